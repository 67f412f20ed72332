import type { TechniqueName } from '@farol/renderer';
import type { EffectName } from '@farol/renderer/effects';
import type { DeviceName } from '../pages/devices';
import { isWhole } from '@farol/tools/extent';
import { expect, test } from '../support/test';

/**
 * Devices by subtraction: what a device lacks is hidden from the page, and what is drawn must be as by stock three there, or
 * be refused or left out by one sentence. `npm test` takes three devices by a few techniques; `npm run devices` all,
 * with a larger scene and every effect.
 */

const TECHNIQUES: readonly TechniqueName[] = [
  ...(['auto', 'forward', 'deferred', 'inferred', 'tiled-deferred', 'forward-plus', 'forward-single-pass'] as const),
  ...(['light-prepass', 'tiled-forward', 'clustered-deferred', 'clustered-forward'] as const),
];
const EFFECTS: readonly EffectName[] = [
  ...(['decals', 'ambient-occlusion', 'order-independent-transparency', 'smaa', 'edges', 'taa'] as const),
];
/** Those that change the picture of a scene without decals. */
const CHANGES: readonly EffectName[] = ['smaa', 'edges', 'taa', 'ambient-occlusion'];

/** Techniques and effects that `npm test` draws on a device. */
type Few = readonly [techniques: readonly TechniqueName[], effects: readonly EffectName[]];

/** Devices by what they lack; null for those that `npm run devices` alone has. */
const LACKS: Record<DeviceName, Few | null> = {
  nothing: null,
  'colour buffers of whole floats': null,
  'float colour buffers': [['auto', 'deferred'], EFFECTS],
  'blending of floats': null,
  'linear filtering of floats': null,
  timers: null,
  'a fifth draw buffer': null,
  'textures above 2048': null,
  'textures above 4096': null,
  'texture units above 16': null,
  'varyings above 15': null,
  'fragment uniforms above 224': null,
  'highp in fragments': [['tiled-deferred'], []],
  'several draws a call': null,
  'anisotropic filtering': null,
  'compiling aside': null,
  'anything above the least limits': [['tiled-deferred'], ['decals', 'ambient-occlusion']],
  'anything but WebGL 2 itself': null,
};

/** Limits for shadows: seams of cube maps, and edges of texels. */
const WHOLE_SCENE = { psnr: 55, share: 0.006 };
const SCENE = { psnr: 60, share: 0.001 };

for (const [name, few] of Object.entries(LACKS) as [DeviceName, Few | null][]) {
  if (few === null && !isWhole) continue;
  test(`a device without ${name}: the picture of stock three, or one sentence`, async ({ benchPage: page, watch }) => {
    test.setTimeout(isWhole ? 600_000 : 120_000);
    const [names, effectNames] = isWhole ? [TECHNIQUES, EFFECTS] : few!;
    const run = { names, effectNames, whole: isWhole, rounds: isMediump(name) };
    const { results, beyond, stockPSNR } = await page.evaluate(([name, run]) => window.testPage.drawDevice(name, run), [
      name,
      run,
    ] as const);
    const floats = name !== 'float colour buffers' && name !== 'anything but WebGL 2 itself';
    const asked = new Set<string>();
    // where the driver honours mediump, stock three's picture is rounded too: each must be as near to the full device's
    const isRounded = isMediump(name) && stockPSNR < 60;
    for (const { technique, effect, refused, errors, psnr = 0, share = 0, wholePSNR = 0 } of results) {
      const said = `${technique}, effect ${effect}: ${psnr.toFixed(1)} dB, ${(share * 100).toFixed(2)}% off ${refused}`;
      test.info().annotations.push({ type: 'device', description: said });
      if (refused !== '') {
        expect.soft(floats, said).toBe(false);
        expect
          .soft(refused)
          .toMatch(/^Farol: this device draws to no float colour buffers .*; use the technique '.*\.$/);
        continue;
      }
      asked.add(effect);
      expect.soft(errors, `${said}: GL errors`).toBe(0);
      const changes = floats && CHANGES.includes(effect as EffectName);
      if (isRounded) {
        const least = Math.min(stockPSNR - 3, changes ? 25 : Infinity);
        expect.soft(wholePSNR, `${said}, stock three ${stockPSNR.toFixed(1)} dB`).toBeGreaterThanOrEqual(least);
        continue;
      }
      const limits = technique === 'inferred' ? { psnr: 35, share: 0.12 } : isWhole ? WHOLE_SCENE : SCENE;
      expect.soft(psnr, said).toBeGreaterThanOrEqual(changes ? 25 : limits.psnr);
      expect.soft(share, said).toBeLessThanOrEqual(changes ? 0.1 : limits.share);
    }
    expect(asked.has('none')).toBe(true);
    expect(beyond).toEqual([]);
    // three tells of what it misses; Farol of each effect once for each object
    watch.forgive(/THREE.WebGLRenderer: .* not supported/);
    const left = watch.forgive(/Farol: [A-Za-z -]+ (is|are) left out, since (this|its?) /);
    const wanted = !floats ? run.effectNames.length : beyondFour(name) ? 1 : 0;
    expect(left, 'effects that were left out').toBe(wanted);
  });
}

/** Devices on which the quality 'auto' is 'lite', each drawn by a technique that it can run. */
const LITE = [
  ['float colour buffers', 'forward-single-pass'],
  ['colour buffers of whole floats', 'tiled-deferred'],
  ['a fifth draw buffer', 'tiled-deferred'],
  ['textures above 4096', 'clustered-deferred'],
  ['highp in fragments', 'tiled-deferred'],
] as const satisfies [DeviceName, TechniqueName][];

for (const [name, technique] of LITE) {
  const tag = name === 'float colour buffers' ? '' : ' @verify';
  test(`a device without ${name} is drawn by the quality lite, as by full${tag}`, async ({
    benchPage: page,
    watch,
  }) => {
    const { quality, gbufferPixel, psnr, errors, beyond } = await page.evaluate(
      ([name, technique, whole]) => window.testPage.drawQuality(name, technique, whole),
      [name, technique, isWhole] as const,
    );
    watch.forgive(/THREE.WebGLRenderer: .* not supported/);
    expect([quality, gbufferPixel]).toEqual([
      'lite',
      technique === 'forward-single-pass' ? 0 : name === 'colour buffers of whole floats' ? 18 : 14,
    ]);
    expect(psnr).toBeGreaterThanOrEqual(45);
    expect([errors, beyond]).toEqual([0, []]);
  });
}

const isMediump = (name: DeviceName): boolean =>
  name === 'highp in fragments' || name === 'anything but WebGL 2 itself';
const beyondFour = (name: DeviceName): boolean =>
  name === 'a fifth draw buffer' || name === 'anything above the least limits';
