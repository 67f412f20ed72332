import type { Sound } from '@farol/engine';

/** Side of a picture (pixels). */
const SIZE = 192;
/** From one stroke of the wave to the next (pixels). */
const STEP = 4;
/** Between the light and the dark theme's accents: seen on both. */
const COLOUR = '#4b93d8';

/** The loudest sample of each of `count` equal parts, 0 to 1. */
export function peaksOf(samples: Float32Array, count: number): Float32Array {
  const peaks = new Float32Array(count);
  for (let i = 0; i < count; i++) {
    const end = Math.floor(((i + 1) * samples.length) / count);
    for (let at = Math.floor((i * samples.length) / count); at < end; at++)
      peaks[i] = Math.max(peaks[i], Math.abs(samples[at]));
  }
  return peaks;
}

/** An address of a picture of a sound's wave; null where it cannot be decoded. */
export async function soundPicture(sound: Sound): Promise<string | null> {
  const buffer = await sound.decode();
  if (!buffer) return null;
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = SIZE;
  const context = canvas.getContext('2d')!;
  context.strokeStyle = COLOUR;
  context.lineWidth = STEP / 2;
  context.lineCap = 'round';
  const peaks = peaksOf(buffer.getChannelData(0), SIZE / STEP);
  const loudest = Math.max(0.05, ...peaks);
  context.beginPath();
  peaks.forEach((peak, i) => {
    const height = Math.max(0.02, peak / loudest) * SIZE * 0.4;
    const x = (i + 0.5) * STEP;
    context.moveTo(x, SIZE / 2 - height);
    context.lineTo(x, SIZE / 2 + height);
  });
  context.stroke();
  return new Promise((resolve) => {
    canvas.toBlob((blob) => resolve(blob && URL.createObjectURL(blob)));
  });
}
