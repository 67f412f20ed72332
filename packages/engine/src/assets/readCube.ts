import { shortText } from '@farol/editing';
import { ClampToEdgeWrapping, DataTexture, LinearFilter, NoColorSpace } from 'three';

/** Greatest side of a colour table (LUT); 64 is usual. */
const MOST = 128;

/**
 * Reads a colour table (LUT) in Adobe's .cube format as an image of its slices in a row, the form that grading expects.
 * @throws Error that says what is wrong with the text
 * @see Adobe 2013, Cube LUT Specification 1.0
 */
export function readCube(bytes: ArrayBuffer): DataTexture {
  const lines = new TextDecoder().decode(bytes).split(/\r?\n/);
  let size = 0;
  let range: readonly [least: number, most: number] = [0, 1];
  const colours: number[] = [];
  for (const line of lines) {
    const [first, ...rest] = line.trim().split(/\s+/);
    if (first === '' || first.startsWith('#') || first === 'TITLE') continue;
    if (first === 'LUT_1D_SIZE') throw new Error('it is a 1D table: export a 3D one (LUT_3D_SIZE).');
    if (first === 'LUT_3D_SIZE') size = sizeOf(rest[0]);
    else if (first === 'DOMAIN_MIN') range = [Number(rest[0]), range[1]];
    else if (first === 'DOMAIN_MAX') range = [range[0], Number(rest[0])];
    else if (/^[-+.\d]/.test(first)) {
      if (colours.length >= size ** 3 * 3)
        throw new Error(`it has more colours than its size of ${size} allows: export it again.`);
      for (const text of [first, rest[0], rest[1]]) colours.push(Number(text));
    }
  }
  if (range[0] !== 0 || range[1] !== 1)
    throw new Error('its colours are not from 0 to 1 (DOMAIN_MIN, DOMAIN_MAX): export it for sRGB pictures.');
  if (size === 0 || colours.length !== size ** 3 * 3)
    throw new Error(
      `it has ${colours.length / 3} colours where LUT_3D_SIZE ${size} needs ${size ** 3}: export it again.`,
    );
  const wrong = colours.findIndex((value) => !Number.isFinite(value));
  if (wrong >= 0) throw new Error(`colour ${Math.floor(wrong / 3) + 1} is not three numbers: export it again.`);
  return imageOf(colours, size);
}

function sizeOf(text = ''): number {
  const size = Number(text);
  if (!Number.isInteger(size) || size < 2 || size > MOST)
    throw new Error(`its LUT_3D_SIZE is ${shortText(text)}: give a whole number from 2 to ${MOST}.`);
  return size;
}

function imageOf(colours: readonly number[], size: number): DataTexture {
  const width = size * size;
  const data = new Uint8Array(width * size * 4).fill(255);
  for (let i = 0; i < size ** 3; i++) {
    const [red, green, blue] = [i % size, Math.floor(i / size) % size, Math.floor(i / size ** 2)];
    const at = (green * width + blue * size + red) * 4;
    for (let channel = 0; channel < 3; channel++) {
      data[at + channel] = Math.round(Math.min(1, Math.max(0, colours[i * 3 + channel])) * 255);
    }
  }
  const texture = new DataTexture(data, width, size);
  texture.colorSpace = NoColorSpace;
  texture.wrapS = texture.wrapT = ClampToEdgeWrapping;
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}
