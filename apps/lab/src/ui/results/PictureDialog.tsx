import { t } from '@farol/editing';
import { useEffect, useRef, useState } from 'preact/hooks';
import type { LabPlan } from '../../plan/LabPlan';
import { competitorLabel } from '../../words/names';
import { PixelCanvas } from '../PixelCanvas';
import { sharpPicture } from '../support/sharpPictures';
import { differenceOf, GAIN } from './differenceOf';
import { psnrText, type TableRow } from './rowColumns';

interface PictureDialogProps {
  plan: LabPlan;
  row: TableRow;
  /** Row of the reference picture; null if the run has none. */
  reference: TableRow | null;
  onClose(): void;
}

export function PictureDialog({ plan, row, reference, onClose }: PictureDialogProps) {
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => dialog.current?.showModal(), []);
  const isReference = reference === null || reference.competitor === row.competitor;
  const pixels = usePixels(plan, row);
  const other = usePixels(plan, isReference ? null : reference);
  const isSharp = sharpPicture(plan, row) !== undefined;
  return (
    <dialog
      ref={dialog}
      class="picture-dialog"
      aria-labelledby="picture-title"
      onClose={onClose}
      onClick={({ target, currentTarget }) => target === currentTarget && currentTarget.close()}
    >
      <div class="dialog-head">
        <h3 id="picture-title">{row.label}</h3>
        <button type="button" onClick={() => dialog.current?.close()}>
          {t('Close')}
        </button>
      </div>
      <div class="large-pictures">
        <figure>
          <PixelCanvas pixels={pixels} label={t('Drawn by {name}', { name: row.label })} />
          <figcaption>
            {row.label}
            {!isReference && (row.likeness?.psnr === null ? t(': equal') : `: ${psnrText(row.likeness)} dB`)}
          </figcaption>
        </figure>
        {!isReference && (
          <>
            <figure>
              <PixelCanvas pixels={other} label={t('The reference, drawn by {name}', { name: reference.label })} />
              <figcaption>{t('Reference: {name}', { name: reference.label })}</figcaption>
            </figure>
            <figure>
              <PixelCanvas
                pixels={pixels && other && differenceOf(pixels, other)}
                label={t('Difference of the pictures')}
              />
              <figcaption>
                {t('Difference, {factor} times brighter; black where both are equal', { factor: GAIN })}
              </figcaption>
            </figure>
          </>
        )}
      </div>
      {reference === null && (
        <p class="dim">
          {t('The reference, drawn by {name}, is not among the pictures.', {
            name: competitorLabel(row.likeness!.reference),
          })}
        </p>
      )}
      {!isSharp && !isReference && (
        <p class="dim">
          {t(
            'These are the small pictures that a run keeps; the difference shows their compression too. Right after a run the pictures are shown as they were drawn.',
          )}
        </p>
      )}
    </dialog>
  );
}

/** Picture of a row: the original if still in memory, otherwise the thumbnail; null while that is being decoded. */
function usePixels(plan: LabPlan, row: TableRow | null): ImageData | null {
  const sharp = row ? sharpPicture(plan, row) : undefined;
  const [small, setSmall] = useState<ImageData | null>(null);
  useEffect(() => {
    if (sharp || !row?.likeness) return;
    let isOver = false;
    void decode(row.likeness.thumbnail).then((pixels) => isOver || setSmall(pixels));
    return () => void (isOver = true);
  }, [sharp, row]);
  return sharp ?? small;
}

async function decode(url: string): Promise<ImageData> {
  const image = new Image();
  image.src = url;
  await image.decode();
  const canvas = document.createElement('canvas');
  canvas.width = image.naturalWidth;
  canvas.height = image.naturalHeight;
  const context = canvas.getContext('2d')!;
  context.drawImage(image, 0, 0);
  return context.getImageData(0, 0, canvas.width, canvas.height);
}
