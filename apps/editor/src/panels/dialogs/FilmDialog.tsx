import { Dialog } from '@base-ui/react/dialog';
import { formatNumber, t } from '@farol/editing';
import { Camera } from '@farol/engine';
import { type ReactNode, useEffect, useState } from 'react';
import type { EditorApi } from '../../api/EditorApi';
import {
  bestFormat,
  filmFormats,
  type FilmFormatName,
  filmProblem,
  type VideoSize,
} from '../../files/film/filmFormats';
import { FASTEST, framesBetween, knownRates, rateOf, SLOWEST } from '../../files/film/frameRate';
import { MOST_FRAMES } from '../../files/film/FramesWriter';
import { saveFilm } from '../../files/film/saveFilm';
import { keptViews, type ShotName } from '../../files/film/shots';
import { Button } from '../../ui/Button';
import { useEditor } from '../../ui/EditorContext';
import type { SelectOption } from '../../ui/SelectBox';
import { ChoiceRow, SwitchRow } from '../../ui/SettingRow';
import { NumberRow, PixelSize, type Size } from './PixelSize';

/** Largest side of a film (pixels). */
const LARGEST = 8192;
/** Latest time at which a film ends (s): a day. */
const LATEST = 86_400;
/** Names of common sizes, not translated. */
const sizes = { '720p': [1280, 720], '1080p': [1920, 1080], '4K': [3840, 2160] } as const;

/** Factors on a format's bits per pixel. */
const qualities = { small: 0.5, good: 1, high: 2.5 } as const;

/** Settings of the dialog, remembered until the page is closed, since films are often made again. */
interface FilmSettings {
  /** Format of the file; null until it is known which formats the browser encodes. */
  readonly format: FilmFormatName | null;
  readonly size: Size;
  /** Frames per second. */
  readonly rate: number;
  readonly ownRate: boolean;
  /** Scene times of the film's beginning and end (s). */
  readonly from: number;
  readonly to: number;
  readonly shot: ShotName;
  readonly turns: number;
  readonly plays: boolean;
  readonly quality: keyof typeof qualities;
  /** Bits per second, as typed; null to compute it from `quality`. */
  readonly bitrate: number | null;
  readonly isTransparent: boolean;
}

let last: FilmSettings = {
  ...{ format: null, size: sizes['1080p'], rate: 30, ownRate: false, from: 0, to: 10 },
  ...{ shot: 'shown', turns: 1, plays: true, quality: 'good', bitrate: null, isTransparent: false },
};

const keep = (settings: FilmSettings): FilmSettings => (last = settings);

const even = (value: number): number => Math.max(2, 2 * Math.round(value / 2));

/** Viewpoints that the scene offers for a film. */
function shotOptions({ document: { scene } }: EditorApi): SelectOption<ShotName>[] {
  const cameras = scene.componentsOf(Camera);
  const options: SelectOption<ShotName>[] = [{ value: 'shown', label: t('The view as shown') }];
  if (scene.activeCamera)
    options.push({ value: 'active', label: t('The scene’s camera'), help: t('Follows scripts that switch cameras.') });
  if (keptViews(scene).length > 1)
    options.push({ value: 'path', label: t('Through the stored views'), help: t('A smooth path in their order.') });
  const help = t('Around the selection or the scene, from the current view.');
  options.push({ value: 'turntable', label: t('Turntable'), help });
  if (cameras.length > 1) for (const { id, gameObject } of cameras) options.push({ value: id, label: gameObject.name });
  return options;
}

/** Asks the browser whether it encodes such a film. @returns the problem; null for none, undefined until then */
function useProblem(format: FilmFormatName | null, { width, height, bitrate }: VideoSize): string | null | undefined {
  const asked = `${format} ${width} ${height} ${bitrate}`;
  const [answer, setAnswer] = useState<{ readonly asked: string; readonly problem: string | null } | null>(null);
  useEffect(() => {
    if (format === null) return;
    let isOver = false;
    void filmProblem(format, { width, height, bitrate }).then((problem) => isOver || setAnswer({ asked, problem }));
    return () => void (isOver = true);
  }, [asked, format, width, height, bitrate]);
  return answer?.asked === asked ? answer.problem : undefined;
}

/** Saves a film of the scene: while it plays, along a camera's path, or around it as a turntable. */
export function FilmDialog({ onClose }: { onClose(): void }): ReactNode {
  const editor = useEditor();
  const { size: shown } = editor.viewport;
  const [settings, show] = useState(last);
  const set = (change: Partial<FilmSettings>): void => show(keep({ ...last, ...change }));
  /** Value and setter of a setting, for its row. */
  const bind = <Key extends keyof FilmSettings>(key: Key) => ({
    value: settings[key],
    onChange: (next: FilmSettings[Key]) => set({ [key]: next }),
  });
  const { format, size, rate, ownRate, from, to, turns, plays, quality, isTransparent } = settings;
  const shots = shotOptions(editor);
  const shot = shots.some(({ value }) => value === settings.shot) ? settings.shot : 'shown';
  const [width, height] = size;
  const { bits, codec } = filmFormats[format ?? 'vp9'];
  const bitrate = settings.bitrate ?? Math.round(width * height * rate * bits * qualities[quality]);
  const { count } = framesBetween(from, to, rateOf(rate));
  const encoding = useProblem(format, { width, height, bitrate });
  useEffect(() => {
    if (format === null) void bestFormat({ width, height, bitrate }).then((best) => set({ format: best }));
  });
  const problem =
    to <= from
      ? t('The film ends before it begins: raise “To”.')
      : codec === null && count > MOST_FRAMES
        ? t('A ZIP holds {count} frames: choose a shorter film.', { count: String(MOST_FRAMES) })
        : encoding;
  const save = async (): Promise<void> => {
    const saved = saveFilm(
      editor,
      {
        ...{ width, height, rate: rateOf(rate), from, to, plays, shot, turns },
        isTransparent: isTransparent && codec === null,
      },
      format!,
      bitrate,
    );
    onClose();
    await saved;
  };
  const seconds = formatNumber(count / rate, 'short');
  const size_ = formatNumber((bitrate * count) / rate / 8e6, 'short', 1);
  const choices = (names: Readonly<Record<string, string>>): SelectOption<string>[] =>
    Object.entries(names).map(([value, label]) => ({ value, label }));
  return (
    <>
      <Dialog.Title>{t('Save a film')}</Dialog.Title>
      <Dialog.Description>
        {t('Every frame is drawn as a picture of its time, however long it takes. Without sound.')}
      </Dialog.Description>
      <PixelSize
        offered={{ [t('As shown')]: [even(shown.width), even(shown.height)], ...sizes }}
        max={LARGEST}
        {...bind('size')}
      />
      <div className="film-fields">
        <ChoiceRow
          label={t('Camera')}
          value={shot}
          options={shots}
          onChange={(next) => set({ shot: next, plays: next !== 'turntable' && next !== 'path' })}
        />
        <SwitchRow label={t('The scene plays')} {...bind('plays')} />
        {shot === 'turntable' && <NumberRow label={t('Turns')} min={-100} max={100} step={1} {...bind('turns')} />}
        <NumberRow label={t('From')} min={0} max={LATEST} step={1} unit="s" {...bind('from')} />
        <NumberRow label={t('To')} min={0} max={LATEST} step={1} unit="s" {...bind('to')} />
        <ChoiceRow
          label={t('Frames a second')}
          value={ownRate ? 'own' : String(rate)}
          options={choices({
            ...Object.fromEntries(Object.keys(knownRates).map((each) => [each, each])),
            own: t('Other…'),
          })}
          onChange={(next) => set(next === 'own' ? { ownRate: true } : { ownRate: false, rate: Number(next) })}
        />
        {ownRate && (
          <NumberRow label={t('Other rate')} min={SLOWEST} max={FASTEST} step={1} unit="1/s" {...bind('rate')} />
        )}
        <ChoiceRow
          label={t('Format')}
          value={format ?? ''}
          options={choices(
            Object.fromEntries(
              Object.entries(filmFormats).map(([name, each]) => [
                name,
                name === 'png' ? t('PNG frames (ZIP)') : each.label,
              ]),
            ),
          )}
          onChange={(next) => set({ format: next as FilmFormatName })}
        />
        {codec === null ? (
          <SwitchRow label={t('Without background')} {...bind('isTransparent')} />
        ) : (
          <>
            <ChoiceRow
              label={t('Quality')}
              value={quality}
              options={choices({ small: t('Small file'), good: t('Good'), high: t('High') })}
              onChange={(next) => set({ quality: next as FilmSettings['quality'], bitrate: null })}
            />
            <NumberRow
              label={t('Bitrate')}
              value={bitrate / 1e6}
              min={0.05}
              max={500}
              step={1}
              unit="Mbit/s"
              onChange={(next) => set({ bitrate: Math.round(next * 1e6) })}
            />
          </>
        )}
      </div>
      <p className={problem ? 'film-problem' : 'export-note'} role="status">
        {problem ??
          (codec === null
            ? t('{count} frames, {seconds} s', { count: String(count), seconds })
            : t('{count} frames, {seconds} s, about {size} MB', { count: String(count), seconds, size: size_ }))}
      </p>
      <div className="dialog-buttons">
        <Button label={t('Cancel')} onClick={onClose} />
        <Button look="primary" label={t('Save')} disabled={problem !== null} onClick={() => editor.attempt(save)} />
      </div>
    </>
  );
}
