import type { Vector3Tuple } from '@farol/engine/fields';
import { type ArrangedPlace, type Arrangement, MOST_COPIES } from './Arrangement';

const whole = (count: number): number => Math.min(MOST_COPIES, Math.max(1, Math.round(count)));

/** Places at 0, 1, 2, … times `offset` from each original. @param origins - world positions of the originals (m) */
function linePlaces({ count, offset }: Arrangement, origins: readonly Vector3Tuple[]): ArrangedPlace[] {
  const places: ArrangedPlace[] = [];
  const steps = Math.max(1, Math.floor(whole(count * origins.length) / origins.length));
  for (let i = 0; i < steps; i++) {
    origins.forEach(([x, y, z], source) => {
      places.push({ source, position: [x + i * offset[0], y + i * offset[1], z + i * offset[2]] });
    });
  }
  return places;
}

function ringPlaces(
  { count, radius, arc, turns }: Arrangement,
  [x, y, z]: Vector3Tuple,
  sources: number,
): ArrangedPlace[] {
  const total = Math.max(sources, whole(count));
  const isClosed = Math.abs(arc) >= 2 * Math.PI - 1e-6;
  const step = total > 1 ? arc / (isClosed ? total : total - 1) : 0;
  return Array.from({ length: total }, (_, i) => {
    const angle = i * step;
    const position = [x + radius * Math.cos(angle), y, z - radius * Math.sin(angle)] as const;
    const turn = [0, Math.sin(angle / 2), 0, Math.cos(angle / 2)] as const;
    return { source: i % sources, position, ...(turns && { turn }) };
  });
}

/** Places of a grid, by x first, then z, then y; centred on a point in x and z, and growing upwards from it. */
function gridPlaces({ counts, spacing }: Arrangement, [x, y, z]: Vector3Tuple, sources: number): ArrangedPlace[] {
  const [across, up, along] = counts.map(whole);
  const places: ArrangedPlace[] = [];
  for (let j = 0; j < up; j++) {
    for (let k = 0; k < along; k++) {
      for (let i = 0; i < across; i++) {
        if (places.length >= MOST_COPIES) return places;
        const position = [
          x + (i - (across - 1) / 2) * spacing[0],
          y + j * spacing[1],
          z + (k - (along - 1) / 2) * spacing[2],
        ] as const;
        places.push({ source: places.length % sources, position });
      }
    }
  }
  return places;
}

/**
 * The places of a line, a ring or a grid.
 * @param origins - world positions of the originals (m), at least one; rings and grids are centred on their centroid
 */
export function arrangedPlaces(arrangement: Arrangement, origins: readonly Vector3Tuple[]): ArrangedPlace[] {
  if (arrangement.kind === 'line') return linePlaces(arrangement, origins);
  const middle = [0, 1, 2].map((i) => origins.reduce((sum, origin) => sum + origin[i], 0) / origins.length);
  const centre = middle as unknown as Vector3Tuple;
  if (arrangement.kind === 'ring') return ringPlaces(arrangement, centre, origins.length);
  return gridPlaces(arrangement, centre, origins.length);
}
