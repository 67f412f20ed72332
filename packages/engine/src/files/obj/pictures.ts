/** Decoded image: 8-bit sRGB or data, RGBA, top row first, alpha not premultiplied. */
export interface Picture {
  readonly width: number;
  readonly height: number;
  readonly data: Uint8ClampedArray | Uint8Array;
}

/** Number of texels sampled to classify an image. */
const SAMPLES = 4096;

/** Calls `look` for up to `SAMPLES` evenly spread texels, with the index of their first byte. Returns the count. */
function sample({ data }: Picture, look: (at: number) => void): number {
  const texels = data.length / 4;
  const step = Math.max(1, Math.floor(texels / SAMPLES));
  let count = 0;
  for (let texel = 0; texel < texels; texel += step, count++) look(texel * 4);
  return count;
}

/** Whether a supposed height map is a normal map: its texels are directions, most of them near +Z. */
export function holdsNormals(picture: Picture): boolean {
  const { data } = picture;
  let directions = 0;
  const count = sample(picture, (at) => {
    const [x, y, z] = [0, 1, 2].map((k) => data[at + k] / 127.5 - 1);
    const length = Math.hypot(x, y, z);
    if (z > 0.2 && length > 0.75 && length < 1.15 && data[at + 2] > data[at] && data[at + 2] > data[at + 1])
      directions++;
  });
  return directions > count * 0.8;
}

const luminance = (data: Picture['data'], at: number): number =>
  0.2126 * data[at] + 0.7152 * data[at + 1] + 0.0722 * data[at + 2];

/** Slope of a step from black to white between two neighbouring texels. */
const STEEPNESS = 4;

/** Normal map (green up) of a height map that repeats. @param bump - factor of the heights */
export function normalsOfHeights(heights: Picture, bump: number): Picture {
  const { width, height, data } = heights;
  const level = new Float32Array(width * height);
  for (let i = 0; i < level.length; i++) level[i] = luminance(data, i * 4) / 255;
  const result = new Uint8ClampedArray(width * height * 4);
  const factor = (STEEPNESS * bump) / 2;
  for (let y = 0; y < height; y++) {
    const [above, below] = [(y + height - 1) % height, (y + 1) % height];
    for (let x = 0; x < width; x++) {
      const [left, right] = [(x + width - 1) % width, (x + 1) % width];
      const dx = (level[y * width + left] - level[y * width + right]) * factor;
      const dy = (level[below * width + x] - level[above * width + x]) * factor;
      const scale = 127.5 / Math.hypot(dx, dy, 1);
      const at = (y * width + x) * 4;
      result[at] = 127.5 + dx * scale;
      result[at + 1] = 127.5 + dy * scale;
      result[at + 2] = 127.5 + scale;
      result[at + 3] = 255;
    }
  }
  return { width, height, data: result };
}

/** Whether any texel of a picture is transparent. */
export function hasAlpha(picture: Picture): boolean {
  let isUsed = false;
  sample(picture, (at) => {
    if (picture.data[at + 3] < 250) isUsed = true;
  });
  return isUsed;
}

/**
 * A colour picture with the opacity of another one: its alpha if any texel is transparent, else its brightness.
 * @param colour - white when null
 */
export function withOpacity(colour: Picture | null, opacity: Picture): Picture {
  const { width, height } = colour ?? opacity;
  const byAlpha = hasAlpha(opacity);
  const data = new Uint8ClampedArray(width * height * 4).fill(255);
  for (let y = 0; y < height; y++) {
    const row = Math.floor((y * opacity.height) / height) * opacity.width;
    for (let x = 0; x < width; x++) {
      const at = (y * width + x) * 4;
      if (colour) for (let k = 0; k < 3; k++) data[at + k] = colour.data[at + k];
      const from = (row + Math.floor((x * opacity.width) / width)) * 4;
      data[at + 3] = byAlpha ? opacity.data[from + 3] : luminance(opacity.data, from);
    }
  }
  return { width, height, data };
}

/** Whether alpha is nearly everywhere 0 or 1, as in the picture of a leaf. */
export function isCutOut(picture: Picture): boolean {
  let between = 0;
  const count = sample(picture, (at) => {
    const alpha = picture.data[at + 3];
    if (alpha > 25 && alpha < 230) between++;
  });
  return between < count * 0.1;
}

/**
 * Roughness texture (green channel, as in glTF) of a map of specular strength.
 * @param smoothest - roughness where the map is white
 */
export function roughnessOfSpecular(specular: Picture, smoothest: number): Picture {
  const { width, height, data } = specular;
  const result = new Uint8ClampedArray(data.length);
  for (let at = 0; at < data.length; at += 4) {
    result[at + 1] = 255 + (smoothest - 1) * luminance(data, at);
    result[at + 3] = 255;
  }
  return { width, height, data: result };
}
