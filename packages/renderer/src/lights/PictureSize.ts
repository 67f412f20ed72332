/** Size of what is drawn (pixels). */
export interface PictureSize {
  readonly width: number;
  readonly height: number;
}
