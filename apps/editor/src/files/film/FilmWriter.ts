/** Takes the frames of a film from a canvas, one after the other. */
export interface FilmWriter {
  /**
   * Takes what the canvas holds as the next frame, at once; resolves when there is room for another.
   * @throws Error (as a rejection) when the frame cannot be encoded or written
   */
  add(): Promise<void>;
  /** Ends the film. @returns the film; null when it is in a file */
  end(): Promise<Blob | null>;
  /** Gives the film up; a file stays as it was. */
  abort(): Promise<void>;
}
