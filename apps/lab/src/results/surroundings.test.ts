import { expect, it } from 'vitest';
import { surroundingsOf, type NavigatorInfo } from './surroundings';

const device = { renderer: 'ANGLE (NVIDIA, H200)', software: false };
const windows: NavigatorInfo = {
  userAgent: 'Mozilla/5.0 (Windows NT 10.0; Win64; x64) Chrome/142.0.0.0 Safari/537.36',
  hardwareConcurrency: 16,
  userAgentData: {
    brands: [{ brand: 'Chromium', version: '142' }],
    platform: 'Windows',
    getHighEntropyValues: async () => ({
      fullVersionList: [
        { brand: 'Not_A Brand', version: '99.0.0.0' },
        { brand: 'Chromium', version: '142.0.7444.60' },
        { brand: 'Google Chrome', version: '142.0.7444.61' },
      ],
      platformVersion: '15.0.0',
    }),
  },
};

it('names device, browser and system as the browser tells them', async () => {
  expect(await surroundingsOf(device, [], windows)).toMatchObject({
    ...{ device: 'ANGLE (NVIDIA, H200)', browser: 'Google Chrome 142.0.7444.61', system: 'Windows 11', cores: 16 },
    ...{ command: null, warnings: [], date: expect.stringMatching(/^\d{4}-\d\d-\d\dT.*Z$/) },
  });
});

it('names the short version where the browser refuses the long one', async () => {
  const getHighEntropyValues = () => Promise.reject(new Error('refused'));
  const teller = { ...windows, userAgentData: { ...windows.userAgentData!, getHighEntropyValues } };
  expect(await surroundingsOf(device, [], teller)).toMatchObject({ browser: 'Chromium 142', system: 'Windows' });
});

it.each([
  ['0.3.0', 'Windows 0.3.0'], // Windows 8.1
  ['1.0.0', 'Windows 10'],
  ['10.0.0', 'Windows 10'],
  ['13.0.0', 'Windows 11'],
  ['19.0.0', 'Windows 11'],
])('the platform version %s of Windows is that of %s', async (platformVersion, system) => {
  const getHighEntropyValues = async () => ({ platformVersion });
  const teller = { ...windows, userAgentData: { ...windows.userAgentData!, getHighEntropyValues } };
  expect(await surroundingsOf(device, [], teller)).toMatchObject({ system });
});

it.each([
  ['Mozilla/5.0 (X11; Linux x86_64; rv:150.0) Gecko/20100101 Firefox/150.0', 'Firefox 150.0', 'Linux'],
  [
    'Mozilla/5.0 (Macintosh; Intel Mac OS X 10_15_7) AppleWebKit/605.1.15 Version/26.1 Safari/605.1.15',
    ...['Safari 26.1', 'macOS 10.15.7'],
  ],
  [
    'Mozilla/5.0 (iPhone; CPU iPhone OS 18_6 like Mac OS X) AppleWebKit/605 Version/26.0 Mobile Safari/604.1',
    ...['Safari 26.0', 'iOS 18.6'],
  ],
  ['Mozilla/5.0 (Windows NT 10.0) Chrome/142.0.0.0 Safari/537.36 Edg/142.0.1', 'Edge 142.0.1', 'Windows 10.0'],
  ['', 'unknown', 'unknown'],
])('reads the user agent %j where there is nothing else', async (userAgent, browser, system) => {
  expect(await surroundingsOf(device, [], { userAgent })).toMatchObject({ browser, system, cores: null });
});

it('warns of a software rasteriser', async () => {
  const { warnings } = await surroundingsOf({ renderer: 'SwiftShader', software: true }, [], windows);
  expect(warnings).toEqual([expect.stringContaining('software rasteriser')]);
});
