/** Sample rate of decoded sounds (Hz); contexts of other rates resample. */
const RATE = 48000;

/** A sound file of a library: its bytes, decoded on first use. */
export class Sound {
  readonly isSound = true;
  name = '';

  private decoding: Promise<AudioBuffer | null> | null = null;
  private decoded: AudioBuffer | null = null;

  /**
   * @param bytes - MP3, Ogg, WAV, M4A or FLAC, where the browser decodes it
   * @param reserve - called with the size of the samples (bytes) before they are decoded; throws to refuse them
   */
  constructor(
    readonly bytes: ArrayBuffer,
    private readonly reserve: (memory: number) => void = () => {},
  ) {}

  /** Decoded samples; null until decoded. */
  get buffer(): AudioBuffer | null {
    return this.decoded;
  }

  /**
   * Decodes the bytes, once.
   * @returns the samples; null where there is no Web Audio, such as in Node
   * @throws Error (as a rejection) when the browser cannot decode the bytes, or `reserve` refuses the samples
   */
  decode(): Promise<AudioBuffer | null> {
    this.decoding ??= this.read();
    return this.decoding;
  }

  dispose(): void {
    this.decoded = null;
    this.decoding = null;
  }

  private async read(): Promise<AudioBuffer | null> {
    // decodes without an audio device, and so without a user gesture
    if (typeof OfflineAudioContext === 'undefined') return null;
    const { checkSound } = await import('../guard/sounds/checkSound');
    this.reserve(checkSound(this.bytes, RATE));
    const context = new OfflineAudioContext(1, 1, RATE);
    try {
      // decodeAudioData detaches its buffer, so it gets a copy
      this.decoded = await context.decodeAudioData(this.bytes.slice(0));
    } catch (cause) {
      throw new Error('it cannot be decoded: convert it to MP3, Ogg or WAV.', { cause });
    }
    return this.decoded;
  }
}
