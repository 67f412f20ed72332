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
import { SwitchRow } from '../../ui/SettingRow';
import { PixelSize, type Size } from './PixelSize';

/** Largest side of a picture (pixels). */
const LARGEST = 32_768;
/** Names of common sizes, not translated. */
const sizes = { '1080p': [1920, 1080], '4K': [3840, 2160], '8K': [7680, 4320], '16K': [15_360, 8640] } as const;
/** Effects that need the whole picture, and cannot be drawn in tiles. */
const wholeEffects = ['bloom', 'depthOfField', 'vignette'] as const;

/** Saves the viewport camera's view of the scene as a PNG of any size. */
export function PictureDialog({ onClose }: { onClose(): void }): ReactNode {
  const editor = useEditor();
  const { document, viewport, dialogs, notices } = editor;
  const { settings, name } = document.scene;
  const isWhole = settings.exposureBy === 'automatic' || wholeEffects.some((effect) => settings[effect]);
  const max = isWhole ? WHOLE : LARGEST;
  const [size, setSize] = useState<Size>(sizes['1080p']);
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
  const offered = { [t('As shown')]: [width, height] as const, ...sizes };
  return (
    <>
      <Dialog.Title>{t('Save a picture')}</Dialog.Title>
      <Dialog.Description>
        {t('The scene as it is seen now, without grid, icons and handles, as a PNG.')}
      </Dialog.Description>
      <PixelSize offered={offered} value={size} max={max} onChange={setSize} />
      <SwitchRow label={t('Without background')} value={isTransparent} onChange={setTransparent} />
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
