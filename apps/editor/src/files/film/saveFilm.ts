import { Signal, t } from '@farol/editing';
import type { EditorApi } from '../../api/EditorApi';
import type { WorkProgress } from '../../model/Dialogs';
import { fileNameOf } from '../fileNameOf';
import { download } from '../share/download';
import { withProgress } from '../withProgress';
import { drawFilm, type FilmOptions } from './drawFilm';
import { FilmFile } from './FilmFile';
import { filmFormats, type FilmFormatName } from './filmFormats';
import type { FilmWriter } from './FilmWriter';
import { framesBetween } from './frameRate';
import { FramesWriter } from './FramesWriter';
import { VideoWriter } from './VideoWriter';

/** Progress of a film, with the remaining time estimated from the frames so far. */
class FilmProgress implements WorkProgress {
  readonly changed = new Signal();
  share = 0;
  text = '';
  private readonly started = performance.now();

  constructor(private readonly count: number) {}

  tell(frame: number): void {
    this.share = frame / this.count;
    const passed = (performance.now() - this.started) / 1000;
    const left = frame === 0 ? 0 : (passed * (this.count - frame)) / frame;
    const parts = { frame: String(frame + 1), count: String(this.count), left: leftText(left) };
    this.text =
      left < 1 ? t('Frame {frame} of {count}', parts) : t('Frame {frame} of {count}, about {left} left', parts);
    this.changed.emit();
  }
}

function leftText(seconds: number): string {
  return seconds < 90 ? `${Math.ceil(seconds)} s` : `${Math.ceil(seconds / 60)} min`;
}

/**
 * Makes a film and saves it, with a progress dialog that can cancel it. Call at the user's click, before anything is
 * awaited.
 * @param bitrate - bit/s of video
 * @throws AbortError when cancelled; errors of `drawFilm` and of writing the file
 */
export async function saveFilm(
  editor: EditorApi,
  options: FilmOptions,
  format: FilmFormatName,
  bitrate: number,
): Promise<void> {
  const { document, viewport, dialogs, notices } = editor;
  const { label, extension, type, codec } = filmFormats[format];
  const fileName = `${fileNameOf(document.scene.name)}.${extension}`;
  const file = await FilmFile.ask(fileName, t('Film'), type);
  const { canvas } = viewport;
  const progress = new FilmProgress(framesBetween(options.from, options.to, options.rate).count);
  const open = (): Promise<FilmWriter> | FilmWriter =>
    codec === null
      ? new FramesWriter(canvas, file)
      : VideoWriter.open(canvas, { extension, codec, bitrate, rate: options.rate }, file);
  const make = async (signal: AbortSignal): Promise<Blob | null> => {
    let writer: FilmWriter | FilmFile | null = file;
    try {
      const opened = (writer = await open());
      await drawFilm(editor, options, opened, (frame) => progress.tell(frame), signal);
      return await opened.end();
    } catch (error) {
      await writer?.abort();
      if (!(error instanceof DOMException) || error.name !== 'EncodingError') throw error;
      throw new Error(t('The browser could not go on encoding {format}: choose another format.', { format: label }), {
        cause: error,
      });
    }
  };
  const film = await withProgress(dialogs, t('Making the film'), make, progress);
  if (film) await download(film, fileName, t('Film'));
  notices.show('info', t('Saved {fileName}', { fileName: file?.name ?? fileName }));
}
