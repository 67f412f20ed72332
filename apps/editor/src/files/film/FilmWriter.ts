/** Adds frames to a film, from a canvas, one after the other. */
export interface FilmWriter {
  /**
   * Copies the canvas at once as the next frame; resolves when another one can be added.
   * @throws Error (as a rejection) when the frame cannot be encoded or written
   */
  add(): Promise<void>;
  /** Ends the film. @returns the film's bytes; null when they were written to a file */
  end(): Promise<Blob | null>;
  /** Cancels the film; a file keeps its former content. */
  abort(): Promise<void>;
}
