/** Size of the picture that is drawn (pixels). */
export interface PictureSize {
  readonly width: number;
  readonly height: number;
}
