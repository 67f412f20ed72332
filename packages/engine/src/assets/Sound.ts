/** A sound file of a library, as its bytes: decoded once an AudioContext is there. */
export class Sound {
  readonly isSound = true;
  name = '';

  /** @param bytes - MP3, Ogg, WAV, or whatever else the browser decodes */
  constructor(readonly bytes: ArrayBuffer) {}

  dispose(): void {}
}
