/** Length, channels and rate of a decoded sound. */
export interface SoundSize {
  /** Duration of the sound (s). */
  readonly seconds: number;
  /** Number of audio channels. */
  readonly channels: number;
  /** Sample rate (Hz). */
  readonly rate: number;
}
