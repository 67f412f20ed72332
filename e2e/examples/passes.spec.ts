import type { Case } from '../pages/composers';
import { expect, test } from '../support/test';

const cases: Record<'three' | 'pmndrs' | 'effects', Record<string, Case>> = {
  three: {
    plain: {},
    'depth texture': { depth: true },
    'multisampled buffers': { samples: 4 },
    'multisampled depth texture': { samples: 4, depth: true },
    'clear colour and alpha': { bare: true, clearColor: 0x804020, pass: { clearAlpha: 0.25 } },
    'normals as override': { override: 'normal' },
    'a lit override': { override: 'lit' },
    'no clear: over what is there, by its depth': { bare: true, before: true, pass: { clear: false } },
    'no clear but depth: an overlay': { bare: true, before: true, pass: { clear: false, clearDepth: true } },
  },
  pmndrs: {
    plain: {},
    'multisampled buffers': { samples: 4 },
    'clear colour': { clearColor: 0x804020 },
    'without the background': { pass: { ignoreBackground: true } },
    'a lit override': { override: 'lit' },
  },
  effects: { 'setEffects of WebGLRenderer, tone mapped': {} },
};

for (const technique of ['clustered-forward', 'deferred'] as const) {
  const deferred = technique === 'deferred';
  test(`FarolPass draws as RenderPass does, ${technique}${deferred ? '' : ' @verify'}`, async ({ page, pagesURL }) => {
    await page.goto(`${pagesURL}composers.html`);
    await page.waitForFunction(() => 'compareInComposer' in window);
    for (const [host, list] of Object.entries(cases)) {
      for (const [name, options] of Object.entries(list)) {
        if (deferred && options.samples) continue; // a G-buffer has one sample a pixel: edges differ from stock three's
        const { psnr, share, flat, kept } = await page.evaluate(
          ([host, technique, options]) => window.compareInComposer(host, technique, options),
          [host as 'three', technique, options] as const,
        );
        const title = `${host}, ${name}`;
        expect.soft(flat, `${title}: something to see`).toBe(false);
        expect.soft(psnr, `${title}: PSNR (dB)`).toBeGreaterThanOrEqual(deferred ? 55 : 60);
        expect.soft(share, `${title}: share off by more than 2/255`).toBeLessThanOrEqual(0.001);
        expect.soft(kept, `${title}: renderer and scene as they were`).toBe(true);
      }
    }
  });
}
