/** Height of the small picture (CSS pixels), and its largest width. */
const HEIGHT = 130;
const WIDEST = 260;
const MARGIN = 10;

/** Rectangle of a camera's small picture, from the right lower corner of the large one (CSS pixels). */
export interface PreviewPlace {
  readonly width: number;
  readonly height: number;
  readonly margin: number;
}

/** The place of a camera's small picture in a picture of a size (CSS pixels), by the form that the camera is given. */
export function previewPlace(width: number, height: number): PreviewPlace {
  const small = Math.min(HEIGHT, height / 3);
  return { width: Math.round(Math.min(WIDEST, (small * width) / height)), height: Math.round(small), margin: MARGIN };
}
