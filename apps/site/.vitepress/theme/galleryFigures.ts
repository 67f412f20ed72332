/** How far an example's picture is from stock three's; see packages/tools/site/galleryExamples.mjs. */
interface Figures {
  readonly technique: string;
  readonly psnr: number | null;
  readonly leftOut: readonly string[];
}

const pictures = import.meta.glob<string>('../../live/assets/stills/gallery/*.webp', {
  query: '?url',
  import: 'default',
  eager: true,
});

/** Address of an example's picture. */
export const pictureOf = (name: string): string | undefined =>
  pictures[`../../live/assets/stills/gallery/${name}.webp`];

/** Agreement with stock three in a few words: '74.2 dB', 'equal'. */
export function agreementOf(figures: Figures | null, language: 'en' | 'es'): string {
  const isSpanish = language === 'es';
  if (figures === null) return isSpanish ? 'sin comparar' : 'not compared';
  if (figures.psnr === null) return isSpanish ? 'igual que three' : 'equal to three';
  return `${figures.psnr.toFixed(1)} dB ${isSpanish ? 'respecto a three' : 'to three'}`;
}

/** Bytes in kB (1,000 bytes). */
export const bytesOf = (bytes: number): string => `${Math.round(bytes / 1000)} kB`;
