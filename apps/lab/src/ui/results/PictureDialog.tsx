import { useEffect, useRef } from 'preact/hooks';
import { competitorLabel } from '../../words/names';
import { psnrText, type TableRow } from './rowColumns';

/** How much brighter differences are shown than they are. */
const GAIN = 8;

interface PictureDialogProps {
  row: TableRow;
  /** The row that drew the reference; null when the run does not keep it. */
  reference: TableRow | null;
  onClose(): void;
}

/** A picture beside the reference, and where they differ. */
export function PictureDialog({ row, reference, onClose }: PictureDialogProps) {
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => dialog.current?.showModal(), []);
  const isReference = reference === null || reference.competitor === row.competitor;
  const psnr = row.likeness?.psnr;
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
          Close
        </button>
      </div>
      <div class="large-pictures">
        <figure>
          <img src={row.likeness!.thumbnail} alt={`Drawn by ${row.label}`} />
          <figcaption>
            {row.label}
            {isReference ? '' : psnr === null ? ': equal' : `: ${psnrText(row.likeness)} dB`}
          </figcaption>
        </figure>
        {!isReference && (
          <>
            <figure>
              <img src={reference.likeness!.thumbnail} alt={`The reference, drawn by ${reference.label}`} />
              <figcaption>Reference: {reference.label}</figcaption>
            </figure>
            <figure>
              <Difference a={row.likeness!.thumbnail} b={reference.likeness!.thumbnail} />
              <figcaption>Difference, {GAIN} times brighter; black where both are equal</figcaption>
            </figure>
          </>
        )}
      </div>
      {reference === null && (
        <p class="dim">
          The reference, drawn by {competitorLabel(row.likeness!.reference)}, is not among the pictures.
        </p>
      )}
    </dialog>
  );
}

function Difference({ a, b }: { a: string; b: string }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    let isOver = false;
    void Promise.all([a, b].map(loadImage)).then(([first, second]) => {
      if (canvas.current && !isOver) drawDifference(canvas.current, first, second);
    });
    return () => void (isOver = true);
  }, [a, b]);
  return <canvas ref={canvas} role="img" aria-label="Where the pictures differ" />;
}

async function loadImage(url: string): Promise<HTMLImageElement> {
  const image = new Image();
  image.src = url;
  await image.decode();
  return image;
}

function drawDifference(canvas: HTMLCanvasElement, a: HTMLImageElement, b: HTMLImageElement): void {
  const { naturalWidth: width, naturalHeight: height } = a;
  Object.assign(canvas, { width, height });
  const context = canvas.getContext('2d', { willReadFrequently: true })!;
  const pixels = (image: HTMLImageElement): ImageData => {
    context.drawImage(image, 0, 0, width, height);
    return context.getImageData(0, 0, width, height);
  };
  const [first, second] = [pixels(a), pixels(b)];
  for (let i = 0; i < first.data.length; i++) {
    first.data[i] = i % 4 === 3 ? 255 : Math.abs(first.data[i] - second.data[i]) * GAIN;
  }
  context.putImageData(first, 0, 0);
}
