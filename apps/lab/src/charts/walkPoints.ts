import type { ChartPoint } from './ChartSpec';

/** The point nearest to a place; null where none lies within `reach` pixels. */
export function nearestPoint(points: readonly ChartPoint[], x: number, y: number, reach: number): ChartPoint | null {
  let nearest: ChartPoint | null = null;
  let least = reach * reach;
  for (const point of points) {
    const distance = (point.x - x) ** 2 + (point.y - y) ** 2;
    if (distance < least) [nearest, least] = [point, distance];
  }
  return nearest;
}

/**
 * Where an arrow key leads: left and right within a group, up and down to the next point of other groups at the same
 * place, Home and End to a group's ends.
 *
 * @param current - null where none is chosen yet: the first point is then
 * @returns undefined for a key that does not walk
 */
export function walkPoints(
  points: readonly ChartPoint[],
  current: ChartPoint | null,
  key: string,
): ChartPoint | undefined {
  if (!['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', 'Home', 'End'].includes(key)) return undefined;
  if (current === null) return points[0];
  if (key === 'ArrowUp' || key === 'ArrowDown') {
    const column = points.filter(({ order }) => order === current.order).sort((a, b) => a.y - b.y);
    return column[column.indexOf(current) + (key === 'ArrowUp' ? -1 : 1)] ?? current;
  }
  const row = points.filter(({ group }) => group === current.group).sort((a, b) => a.order - b.order);
  if (key === 'Home') return row[0];
  if (key === 'End') return row.at(-1);
  return row[row.indexOf(current) + (key === 'ArrowLeft' ? -1 : 1)] ?? current;
}
