import { describe, expect, it } from 'vitest';
import { findBrowser } from './findBrowser.mjs';

function world(there: string[], over: { env?: Record<string, string>; platform?: string; playwright?: string } = {}) {
  return {
    env: { PATH: '/usr/bin:/opt/bin', ...over.env },
    platform: over.platform ?? 'linux',
    exists: (path: string) => there.includes(path),
    playwrightPath: () => over.playwright ?? '/cache/chrome',
  };
}

describe('findBrowser', () => {
  const all = ['/mine/chrome', '/cache/chrome', '/usr/bin/chromium', '/usr/bin/google-chrome'];
  const env = { CHROMIUM_PATH: '/mine/chrome' };

  it("asks the environment, then Playwright, then the system, Chromium before others' builds", () => {
    expect(findBrowser(world(all, { env }))).toEqual({ path: '/mine/chrome', source: 'CHROMIUM_PATH' });
    expect(findBrowser(world(all))).toEqual({ path: '/cache/chrome', source: 'playwright' });
    expect(findBrowser(world(all.slice(2)))).toEqual({ path: '/usr/bin/chromium', source: 'system' });
    expect(findBrowser(world(['/opt/bin/google-chrome']))?.path).toBe('/opt/bin/google-chrome');
    expect(findBrowser(world([]))).toBeNull();
  });

  it('refuses a CHROMIUM_PATH that does not exist, rather than taking another', () => {
    expect(() => findBrowser(world(all.slice(1), { env }))).toThrow(/CHROMIUM_PATH is \/mine\/chrome/);
  });

  it('knows where macOS and Windows keep theirs', () => {
    const mac = '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome';
    expect(findBrowser(world([mac], { platform: 'darwin' }))?.path).toBe(mac);
    const edge = 'C:\\Program Files (x86)\\Microsoft\\Edge\\Application\\msedge.exe';
    const windows = { platform: 'win32', env: { 'PROGRAMFILES(X86)': 'C:\\Program Files (x86)' } };
    expect(findBrowser(world([edge], windows))?.path).toBe(edge);
  });
});
