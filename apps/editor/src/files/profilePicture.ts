import type { PhotometricProfile } from '@farol/renderer/light-profiles';
import { POLAR_RADIUS, polarCurve, shinesUp } from './polarCurve';

/** Side of a thumbnail (pixels). */
const SIZE = 192;
/** Colour visible on light and dark backgrounds. */
const CURVE = '#d98324';
const CROSS = '#4b93d8';
const GRID = '#8a93a3';

/** URL of a thumbnail of a photometric profile: its polar curves. */
export function profilePicture(profile: PhotometricProfile): Promise<string | null> {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = SIZE;
  const context = canvas.getContext('2d')!;
  const isWhole = shinesUp(profile);
  const scale = 0.47 * (SIZE / POLAR_RADIUS);
  context.translate(SIZE / 2, isWhole ? SIZE / 2 : SIZE * 0.27);
  context.lineWidth = 1.5;
  context.strokeStyle = GRID;
  context.globalAlpha = 0.5;
  for (const part of [0.5, 1]) {
    context.beginPath();
    context.arc(0, 0, POLAR_RADIUS * scale * part, 0, isWhole ? 2 * Math.PI : Math.PI);
    context.stroke();
  }
  context.globalAlpha = 1;
  context.lineWidth = 5;
  context.lineJoin = 'round';
  for (const [horizontal, colour] of [
    [90, CROSS],
    [0, CURVE],
  ] as const) {
    context.strokeStyle = colour;
    context.beginPath();
    for (const [x, y] of polarCurve(profile, horizontal, profile.maximumIntensity || 1))
      context.lineTo(x * scale, y * scale);
    context.stroke();
  }
  return new Promise((resolve) => {
    canvas.toBlob((blob) => resolve(blob && URL.createObjectURL(blob)));
  });
}
