/** Length, channels and rate of a sound once it is decoded. */
export interface SoundSize {
  /** Length (s). */
  readonly seconds: number;
  /** Channels of the samples. */
  readonly channels: number;
  /** Samples a second of one channel. */
  readonly rate: number;
}
