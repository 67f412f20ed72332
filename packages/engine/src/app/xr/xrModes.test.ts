import { afterEach, expect, it, vi } from 'vitest';
import { xrModes } from './playInXR';

afterEach(() => vi.unstubAllGlobals());

it.each([
  ['allows headsets', () => true, ['immersive-vr']],
  ['forbids them: the device is not asked', () => false, []],
])('has the modes of the device where the policy of the page %s', async (_, allowsFeature, modes) => {
  const isSessionSupported = vi.fn<(mode: string) => Promise<boolean>>((mode) =>
    Promise.resolve(mode === 'immersive-vr'),
  );
  vi.stubGlobal('navigator', { xr: { isSessionSupported } });
  vi.stubGlobal('document', { featurePolicy: { allowsFeature } });
  expect(await xrModes()).toEqual(modes);
  expect(isSessionSupported).toHaveBeenCalledTimes(2 * modes.length);
});
