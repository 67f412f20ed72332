import { t } from '@farol/editing';
import { canEncodeVideo, Quality, type VideoCodec } from 'mediabunny';

/** A kind of file that films are saved as. */
export interface FilmFormat {
  /** Label: names of container and codec, the same in all languages. The dialog translates that of PNG frames. */
  readonly label: string;
  readonly extension: 'mp4' | 'webm' | 'zip';
  readonly type: string;
  /** Codec of the video; null for pictures. */
  readonly codec: VideoCodec | null;
  /** Bits per pixel and frame at good quality (approximate). */
  readonly bits: number;
}

/** Formats of films, preferred ones first; a browser may be unable to encode some of them. */
export const filmFormats = {
  avc: { label: 'MP4 (H.264)', extension: 'mp4', type: 'video/mp4', codec: 'avc', bits: 0.15 },
  vp9: { label: 'WebM (VP9)', extension: 'webm', type: 'video/webm', codec: 'vp9', bits: 0.1 },
  av1: { label: 'WebM (AV1)', extension: 'webm', type: 'video/webm', codec: 'av1', bits: 0.08 },
  vp8: { label: 'WebM (VP8)', extension: 'webm', type: 'video/webm', codec: 'vp8', bits: 0.15 },
  png: { label: 'PNG', extension: 'zip', type: 'application/zip', codec: null, bits: 12 },
} as const satisfies Record<string, FilmFormat>;

export type FilmFormatName = keyof typeof filmFormats;

/** Properties of a video that an encoder is asked about. */
export interface VideoSize {
  readonly width: number;
  readonly height: number;
  /** Bits per second. */
  readonly bitrate: number;
}

/** Reason and remedy, as a sentence, when this browser cannot make such a film; null when it can. */
export async function filmProblem(name: FilmFormatName, { width, height, bitrate }: VideoSize): Promise<string | null> {
  const { codec, label } = filmFormats[name];
  if (codec === null) return null;
  if (typeof VideoEncoder === 'undefined')
    return t('This browser does not encode video here (WebCodecs needs https and a new browser): choose PNG frames.');
  if (codec === 'avc' && (width % 2 !== 0 || height % 2 !== 0))
    return t('{format} needs an even width and height, such as {width} × {height}.', {
      ...{ format: label, width: width + (width % 2), height: height + (height % 2) },
    });
  if (await canEncodeVideo(codec, { width, height, quality: new Quality({ bitrate }) })) return null;
  return t('This browser does not encode {format} at {width} × {height}: choose another format or a smaller size.', {
    ...{ format: label, width, height },
  });
}

/** The first format that this browser encodes; PNG frames when it encodes none. */
export async function bestFormat(size: VideoSize): Promise<FilmFormatName> {
  for (const name of Object.keys(filmFormats) as FilmFormatName[])
    if ((await filmProblem(name, size)) === null) return name;
  return 'png';
}
