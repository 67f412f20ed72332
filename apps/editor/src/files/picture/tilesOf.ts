/** Part of a picture (pixels from its left and top): the area that is kept, and `drawn`, the area rendered for it. */
export interface Tile {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
  readonly drawn: { readonly x: number; readonly y: number; readonly width: number; readonly height: number };
}

/** Largest side of a picture that is drawn in one piece (pixels): its G-buffer takes about half a gigabyte. */
export const WHOLE = 4096;
/** Side of a tile's kept area (pixels). */
const SIDE = 2048;
/** Pixels drawn around a tile, for effects that read neighbours: anti-aliasing, ambient occlusion. */
const MARGIN = 64;

/** Tiles of a picture, in strips from the top down, each from the left. */
export function tilesOf(width: number, height: number): Tile[][] {
  if (Math.max(width, height) <= WHOLE) {
    const whole = { x: 0, y: 0, width, height };
    return [[{ ...whole, drawn: whole }]];
  }
  const span = (at: number, size: number): [number, number] => [
    Math.max(0, at - MARGIN),
    Math.min(size, at + SIDE + MARGIN) - Math.max(0, at - MARGIN),
  ];
  const starts = (size: number): number[] => Array.from({ length: Math.ceil(size / SIDE) }, (_, i) => i * SIDE);
  return starts(height).map((y) =>
    starts(width).map((x) => {
      const [left, wide] = span(x, width);
      const [top, high] = span(y, height);
      const drawn = { x: left, y: top, width: wide, height: high };
      return { x, y, width: Math.min(SIDE, width - x), height: Math.min(SIDE, height - y), drawn };
    }),
  );
}
