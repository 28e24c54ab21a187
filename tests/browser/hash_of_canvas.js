// FNV-1a, 32 bits, over red, green and blue of what the player shows.
(() => {
  const canvas = document.querySelector(".player canvas");
  const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  let hash = 2166136261;
  data.forEach((byte, k) => { if (k % 4 < 3) hash = Math.imul(hash ^ byte, 16777619) >>> 0; });
  return hash;
})()
