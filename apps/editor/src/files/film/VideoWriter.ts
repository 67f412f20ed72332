import {
  BufferTarget,
  CanvasSource,
  Mp4OutputFormat,
  Output,
  Quality,
  StreamTarget,
  type StreamTargetChunk,
  type VideoCodec,
  WebMOutputFormat,
} from 'mediabunny';
import type { FilmFile } from './FilmFile';
import type { FilmWriter } from './FilmWriter';
import { type FrameRate, timeOf } from './frameRate';

export interface VideoOptions {
  readonly extension: 'mp4' | 'webm';
  readonly codec: VideoCodec;
  /** Bits per second. */
  readonly bitrate: number;
  readonly rate: FrameRate;
}

/** Longest time between key frames, to which players can seek (s). */
const KEY_FRAMES = 2;

/**
 * Writes a film as MP4 or WebM, by the browser's encoder, in sRGB colours by BT.709. Frame times are exact in MP4, and
 * rounded to milliseconds in WebM, as its format demands.
 */
export class VideoWriter implements FilmWriter {
  private frames = 0;

  private constructor(
    private readonly options: VideoOptions,
    private readonly file: FilmFile | null,
    private readonly output: Output<Mp4OutputFormat | WebMOutputFormat, BufferTarget | StreamTarget>,
    private readonly source: CanvasSource,
  ) {}

  /** @param file - written to while the film is made; null keeps it in memory */
  static async open(canvas: HTMLCanvasElement, options: VideoOptions, file: FilmFile | null): Promise<VideoWriter> {
    const { codec, bitrate, rate } = options;
    // a separate stream: the encoder closes its stream when a film is cancelled, which would save the file
    const stream = (to: FilmFile): WritableStream<StreamTargetChunk> =>
      new WritableStream({ write: ({ data, position }) => to.write(data as Uint8Array<ArrayBuffer>, position) });
    const target = file ? new StreamTarget(stream(file), { chunked: true }) : new BufferTarget();
    const format = options.extension === 'mp4' ? new Mp4OutputFormat() : new WebMOutputFormat();
    const output = new Output({ format, target });
    const source = new CanvasSource(canvas, { codec, quality: new Quality({ bitrate }), keyFrameInterval: KEY_FRAMES });
    output.addVideoTrack(source, { frameRate: rate.frames / rate.seconds });
    await output.start();
    return new VideoWriter(options, file, output, source);
  }

  add(): Promise<void> {
    const { rate } = this.options;
    return this.source.add(timeOf(this.frames++, rate), timeOf(1, rate));
  }

  async end(): Promise<Blob | null> {
    await this.output.finalize();
    if (this.file) {
      await this.file.close();
      return null;
    }
    const { buffer } = this.output.target as BufferTarget;
    return new Blob([buffer!], { type: `video/${this.options.extension}` });
  }

  async abort(): Promise<void> {
    await this.output.cancel().catch(() => {});
    await this.file?.abort();
  }
}
