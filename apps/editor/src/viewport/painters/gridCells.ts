/** A rectangle of the viewport (CSS pixels from the upper left corner). */
export interface GridCell {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Height above each cell for its name (CSS pixels). */
export const LABEL = 20;

/** The largest cells that fit, with the viewport's aspect ratio and space for a name above each. */
export function gridCells(count: number, width: number, height: number): GridCell[] {
  let best: { columns: number; rows: number; scale: number } = { columns: 1, rows: count, scale: 0 };
  for (let columns = 1; columns <= count; columns++) {
    const rows = Math.ceil(count / columns);
    const scale = Math.min(1 / columns, (height / rows - LABEL) / height);
    if (scale > best.scale) best = { columns, rows, scale };
  }
  const { columns, rows, scale } = best;
  const [cellWidth, cellHeight] = [width / columns, height / rows];
  const size = { width: Math.max(1, Math.floor(width * scale)), height: Math.max(1, Math.floor(height * scale)) };
  return Array.from({ length: count }, (_, i) => ({
    x: Math.floor((i % columns) * cellWidth + (cellWidth - size.width) / 2),
    y: Math.floor(Math.floor(i / columns) * cellHeight + LABEL + (cellHeight - LABEL - size.height) / 2),
    ...size,
  }));
}
