// The one time that the player and all charts show, s.
plumb.clock = (() => {
  "use strict";
  const end = plumb.data.end_time;
  const listeners = [];
  let time = 0;
  return {
    end,
    get time() { return time; },
    set(value) {
      time = Math.min(Math.max(value, 0), end);
      for (const listener of listeners) listener(time);
    },
    follow(listener) {
      listeners.push(listener);
      listener(time);
    },
  };
})();
