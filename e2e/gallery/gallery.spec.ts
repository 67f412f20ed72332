import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { figuresFile, readExamples, readFigures } from '@farol/tools/site/galleryExamples';
import { liveFolder } from '@farol/tools/site/liveServer';
import { checkAgreement, type Limits } from '../support/agreement';
import { compareImages, isFlat } from '../support/images';
import { drawLive, openLive, pictureOf } from '../support/live';
import { expect, test } from '../support/test';

/** `npm run gallery` leaves what is seen here in figures.json and in the pictures. */
const isWriting = Boolean(process.env.FAROL_GALLERY);
const stills = join(liveFolder, 'assets/stills/gallery');
/** Most bytes of a picture. */
const MOST = 17_500;

/** Small scenes of two kinds: an edited microshader, particles. */
const inSlice = ['attenuation-edited-live', 'campfire'];

/** Limits beside those of a technique, with their reasons. */
const exceptions: Record<string, Limits | undefined> = {
  // docs/limits.md: rows of texels where seams of a point light's cube cross a shadow
  'first-lamp': { largest: 0.05, psnr: 70 },
  'dragon-room': { largest: 0.05, psnr: 70 },
  // one pixel at the edge of a shadow: 9.5e-4 and 114.8 dB
  'light-kinds': { largest: 0.002, psnr: 110 },
  // a graphics card's driver rounds places in shadow maps otherwise in another program: 87.9, 110.5 and 105.18 dB on an H200
  ...(process.env.FAROL_GPU && {
    'sun-cascades': { largest: 0.002, psnr: 85 },
    'dissolving-surface': { largest: 5e-4, psnr: 105 },
    'light-kinds': { largest: 0.002, psnr: 105 },
  }),
};

test.use({ viewport: isWriting ? { width: 480, height: 270 } : { width: 192, height: 108 } });

for (const { name, seconds, frames } of readExamples()) {
  test(`${name}: what stock three can draw of it is stock three's picture${inSlice.includes(name) ? '' : ' @verify'}`, async ({
    page,
    watch,
  }) => {
    await openLive(page, `gallery/${name}`, seconds, frames);
    if (isWriting) {
      mkdirSync(stills, { recursive: true });
      writeFileSync(join(stills, `${name}.webp`), await pictureOf(page, MOST));
    }
    const { stock, farol, technique, leftOut } = await drawLive(page);
    expect(isFlat(stock)).toBe(false);
    const difference = compareImages(farol, stock);
    if (isWriting) {
      const { psnr, largest } = difference;
      const figures = {
        ...readFigures(),
        [name]: { technique, psnr: rounded(psnr), largest: rounded(largest), leftOut },
      };
      const sorted = Object.fromEntries(Object.entries(figures).toSorted(([a], [b]) => a.localeCompare(b)));
      writeFileSync(figuresFile, `${JSON.stringify(sorted, null, 2)}\n`);
    }
    checkAgreement(technique, difference, name, exceptions[name]);
    watch.forgive(/THREE\.Clock: This module has been deprecated/); // React Three Fiber uses it
  });
}

/** Three significant digits; null for what JSON cannot hold. */
const rounded = (value: number): number | null => (Number.isFinite(value) ? Number(value.toPrecision(3)) : null);
