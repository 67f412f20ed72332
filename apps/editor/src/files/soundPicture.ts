import type { Sound } from '@farol/engine';

/** Side of a thumbnail (pixels). */
const SIZE = 192;
/** Distance between two bars of the waveform (pixels). */
const STEP = 4;
/** Colour visible on light and dark backgrounds. */
const COLOUR = '#4b93d8';

/** Peak amplitude of each of `count` equal parts, 0 to 1. */
export function peaksOf(samples: Float32Array, count: number): Float32Array {
  const peaks = new Float32Array(count);
  for (let i = 0; i < count; i++) {
    const end = Math.floor(((i + 1) * samples.length) / count);
    for (let at = Math.floor((i * samples.length) / count); at < end; at++)
      peaks[i] = Math.max(peaks[i], Math.abs(samples[at]));
  }
  return peaks;
}

/** URL of a thumbnail of a sound's waveform; null when it cannot be decoded. */
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
