import { t } from '@farol/editing';
import { Dialog } from '@base-ui/react/dialog';
import { type ReactNode, useState } from 'react';
import { fileNameOf } from '../../files/fileNameOf';
import { drawPicture } from '../../files/picture/drawPicture';
import { WHOLE } from '../../files/picture/tilesOf';
import { download } from '../../files/share/download';
import { withProgress } from '../../files/withProgress';
import { Button } from '../../ui/Button';
import { useEditor } from '../../ui/EditorContext';
import { NumberInput } from '../../ui/NumberInput';
import { Toggle } from '../../ui/Toggle';

/** Largest side of a picture (pixels). */
const LARGEST = 32_768;
/** Names of sizes that are often asked for, not translated. */
const sizes = { '1080p': [1920, 1080], '4K': [3840, 2160], '8K': [7680, 4320], '16K': [15_360, 8640] } as const;
/** Effects that take the picture as a whole, which tiles cannot have. */
const wholeEffects = ['bloom', 'depthOfField', 'vignette'] as const;

interface SideProps {
  readonly label: string;
  readonly value: number;
  readonly max: number;
  onChange(value: number): void;
}

/** One side of the picture in pixels; what is typed and not committed is taken back by Escape. */
function Side({ label, value, max, onChange }: SideProps): ReactNode {
  const [draft, setDraft] = useState<number | null>(null);
  return (
    <div className="tool-row">
      <span aria-hidden="true">{label}</span>
      <NumberInput
        label={label}
        value={draft ?? value}
        min={1}
        max={max}
        step={1}
        unit="px"
        onPreview={(next) => setDraft(Math.round(next))}
        onCommit={() => {
          if (draft !== null) onChange(draft);
          setDraft(null);
        }}
        onDiscard={() => setDraft(null)}
      />
    </div>
  );
}

/** Saves the scene as the viewport's camera sees it as a PNG, at any size. */
export function PictureDialog({ onClose }: { onClose(): void }): ReactNode {
  const editor = useEditor();
  const { document, viewport, dialogs, notices } = editor;
  const { settings, name } = document.scene;
  const isWhole = settings.exposureBy === 'automatic' || wholeEffects.some((effect) => settings[effect]);
  const max = isWhole ? WHOLE : LARGEST;
  const [size, setSize] = useState<readonly [number, number]>(sizes['1080p']);
  const [isTransparent, setTransparent] = useState(false);
  const { width, height } = viewport.size;
  const save = async (): Promise<void> => {
    const fileName = `${fileNameOf(name)}.png`;
    onClose();
    const options = { width: size[0], height: size[1], isTransparent };
    const png = await withProgress(dialogs, t('Drawing the picture'), (signal) => drawPicture(editor, options, signal));
    await download(png, fileName, t('Picture'));
    notices.show('info', t('Saved {fileName}', { fileName }));
  };
  const fits = ([wide, high]: readonly [number, number]): boolean => Math.max(wide, high) <= max;
  const offered = { [t('As shown')]: [width, height] as const, ...sizes };
  return (
    <>
      <Dialog.Title>{t('Save a picture')}</Dialog.Title>
      <Dialog.Description>
        {t('The scene as it is seen now, without grid, icons and handles, as a PNG.')}
      </Dialog.Description>
      <div className="export-row">
        {Object.entries(offered).map(([label, each]) => (
          <Button
            key={label}
            label={label}
            aria-pressed={each[0] === size[0] && each[1] === size[1]}
            disabled={!fits(each)}
            onClick={() => setSize(each)}
          />
        ))}
      </div>
      <Side label={t('Width')} value={size[0]} max={max} onChange={(wide) => setSize([wide, size[1]])} />
      <Side label={t('Height')} value={size[1]} max={max} onChange={(high) => setSize([size[0], high])} />
      <div className="tool-row">
        <span aria-hidden="true">{t('Without background')}</span>
        <Toggle value={isTransparent} label={t('Without background')} onChange={setTransparent} />
      </div>
      {isWhole && (
        <p className="export-note">
          {t('With bloom, depth of field, vignette or automatic exposure at most {count} pixels a side.', {
            count: WHOLE,
          })}
        </p>
      )}
      <div className="dialog-buttons">
        <Button label={t('Cancel')} onClick={onClose} />
        <Button look="primary" label={t('Save')} onClick={() => editor.attempt(save)} />
      </div>
    </>
  );
}
