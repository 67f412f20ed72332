import { describe, expect, it } from 'vitest';
import { isOwnRequest, rivalVersions } from './rivalsPlugin.mjs';

describe('a request to install the other engines', () => {
  const own = { method: 'POST', headers: { host: '127.0.0.1:5175', origin: 'http://127.0.0.1:5175' } };

  it.each([
    ['from the page', own, true],
    ['of a browser that says so', { ...own, headers: { ...own.headers, 'sec-fetch-site': 'same-origin' } }, true],
    ['that only reads', { ...own, method: 'GET' }, false],
    ['of no page', { ...own, headers: { host: '127.0.0.1:5175' } }, false],
    ['of another site', { ...own, headers: { ...own.headers, origin: 'http://example.com' } }, false],
    ['of another port', { ...own, headers: { ...own.headers, origin: 'http://127.0.0.1:80' } }, false],
    ['across sites', { ...own, headers: { ...own.headers, 'sec-fetch-site': 'cross-site' } }, false],
  ])('%s', (_, request, expected) => {
    expect(isOwnRequest(request)).toBe(expected);
  });
});

it('a build without the other engines says so', () => {
  expect(rivalVersions('/nowhere')).toEqual({ versions: {}, canInstall: false });
});
