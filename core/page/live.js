// A page that has not been replaced for long is told to be old: the stream, or vvr, stands still.
const age = document.getElementById("age");
const tell = () => {
    const seconds = Math.max(0, Math.round(Date.now() / 1000 - Number(age.dataset.written)));
    const old = seconds > 2 * Number(age.dataset.brick) + 5;
    age.className = old ? "old" : "";
    age.textContent = old ? `no new picture for ${seconds} s` : `updated ${seconds} s ago`;
};
tell();
setInterval(tell, 1000);
