/** Maximum height and width of a camera's inset (CSS pixels). */
const HEIGHT = 130;
const WIDEST = 260;
const MARGIN = 10;

/** Size of a camera's inset, and its distance from the viewport's lower right corner (CSS pixels). */
export interface PreviewPlace {
  readonly width: number;
  readonly height: number;
  readonly margin: number;
}

/** Place of a camera's inset in a viewport, with the same aspect ratio (CSS pixels). */
export function previewPlace(width: number, height: number): PreviewPlace {
  const small = Math.min(HEIGHT, height / 3);
  return { width: Math.round(Math.min(WIDEST, (small * width) / height)), height: Math.round(small), margin: MARGIN };
}
