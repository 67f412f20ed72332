import type { ChartPoint } from './ChartSpec';

/** The point nearest to a place; null if none lies within `reach` pixels. */
export function nearestPoint(points: readonly ChartPoint[], x: number, y: number, reach: number): ChartPoint | null {
  let nearest: ChartPoint | null = null;
  let nearestSquare = reach * reach;
  for (const point of points) {
    const distance = (point.x - x) ** 2 + (point.y - y) ** 2;
    if (distance < nearestSquare) [nearest, nearestSquare] = [point, distance];
  }
  return nearest;
}

/**
 * Next point for an arrow key: left and right within a group, up and down to the next point of other groups with the
 * same order, Home and End to a group's ends.
 *
 * @param current - the chosen point; null for none: any of these keys then leads to the first point
 * @returns undefined for any key that is not named above
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
