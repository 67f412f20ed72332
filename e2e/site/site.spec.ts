import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { serveFolder } from '@farol/tools/benchServe';
import { root } from '@farol/tools/root';
import { searchIndex } from '@farol/tools/site/searchPages';
import type { FarolRenderer } from '@farol/renderer';
import { axeProblems } from '../support/axeProblems';
import { expect, test as base } from '../support/test';

/** Window of a live module's page. */
interface LiveWindow {
  live: Promise<{ farol: FarolRenderer | Promise<FarolRenderer> }>;
}

const { FAROL_BUILT } = process.env;
const siteFolder = FAROL_BUILT ? join(FAROL_BUILT, 'site') : join(root, 'apps/site/dist');

/** The built site, served from a folder of a host. */
const test = base.extend<object, { site: string }>({
  site: [
    // oxlint-disable-next-line no-empty-pattern -- Playwright reads the names of the fixtures from the pattern
    async ({}, use) => {
      if (!existsSync(join(siteFolder, 'index.html'))) throw new Error('Build the site: npm run build -- --site');
      const server = await serveFolder(root, { isolated: false, beside: { 'a-folder': siteFolder } });
      await use(`${server.url}a-folder/`);
      await server.close();
    },
    { scope: 'worker' },
  ],
});

const questions = [...readFileSync(join(root, 'packages/renderer/docs/faq.md'), 'utf8').matchAll(/^## (.*)$/gm)].map(
  ([, question]) => question.replaceAll('`', ''),
);

for (const colorScheme of ['light', 'dark'] as const) {
  test.describe(colorScheme, () => {
    test.use({ colorScheme, viewport: { width: 390, height: 800 } });

    for (const path of [
      ...['', 'start.html', 'guides/effects.html', 'guides/faq.html', 'techniques/', 'es/'],
      ...['api/', 'api/renderer.html', 'api/engine_components.html'],
    ])
      test(`a phone shows "${path}" without scrolling sideways, and axe finds nothing @verify`, async ({
        page,
        site,
      }) => {
        await page.goto(site + path);
        await expect(page.locator('.Layout')).toBeVisible();
        expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
        expect(await axeProblems(page)).toEqual([]);
      });
  });
}

test('the icons of the bar are seen in forced colours @verify', async ({ page, site }) => {
  await page.emulateMedia({ forcedColors: 'active', colorScheme: 'light' });
  await page.setViewportSize({ width: 390, height: 800 });
  await page.goto(site);
  for (const icon of ['.VPNavBarHamburger .top', '.DocSearch-Search-Icon'])
    await expect(page.locator(icon)).toHaveCSS('background-color', 'rgb(0, 0, 0)');
});

test.describe('on a desk', () => {
  test.use({ viewport: { width: 1440, height: 900 } });

  test('links, languages and reloads stay within the folder that the site lies in @verify', async ({ page, site }) => {
    await page.goto(`${site}guides/attempts/forward.html`);
    const bar = page.getByRole('navigation', { name: 'Main Navigation' });
    await bar.getByRole('link', { name: 'Techniques' }).click();
    await expect(page).toHaveURL(`${site}techniques/`);
    await page.getByRole('complementary').getByRole('link', { name: 'Forward+' }).click();
    await expect(page).toHaveURL(`${site}techniques/forward-plus.html`);
    await page.reload();
    await expect(page.getByRole('heading', { level: 1 })).toHaveText(/^Forward\+/);
    // in Spanish there is no such page
    await page.goto(`${site}es/techniques/forward-plus.html`);
    await expect(page).toHaveURL(`${site}techniques/forward-plus.html`);
    await bar.getByRole('link', { name: 'Guides' }).click();
    await page.getByRole('button', { name: 'Change language' }).hover();
    await page.getByRole('link', { name: 'Español' }).click();
    await expect(page).toHaveURL(`${site}es/guides/lights.html`);
    await expect(page.locator('html')).toHaveAttribute('lang', 'es');
  });

  test('the search, opened by the keyboard, has the answer to each question first @verify', async ({ page, site }) => {
    await page.goto(`${site}start.html`);
    const field = page.getByRole('searchbox');
    // the page listens to keys once its script has run
    await expect(async () => {
      await page.keyboard.press('Control+k');
      await expect(field).toBeVisible({ timeout: 1000 });
    }).toPass();
    const index = searchIndex();
    for (const question of questions) {
      await field.fill(question);
      const first = page.locator('.result').first();
      // site.test.ts holds that this is the page that answers
      const answer = index.search(question)[0].id.replace('.md', '.html');
      await expect(first, question).toHaveAttribute('href', new RegExp(`/a-folder/${answer}$`));
    }
    await page.keyboard.press('Enter');
    await expect(page).toHaveURL(`${site}guides/faq.html#which-browsers`);
  });

  test('the first screen is there before its live scene, which a worker draws @verify', async ({ page, site }) => {
    await page.goto(site);
    const picture = page.locator('.live-box img');
    await expect(picture).toHaveCount(1);
    const seen = await page.waitForFunction(() => {
      const frame = performance.getEntriesByType('resource').find(({ name }) => name.includes('/live/index.html'));
      const [page] = performance.getEntriesByType('navigation');
      return frame && { frame: frame.startTime, loaded: (page as PerformanceNavigationTiming).loadEventStart };
    });
    const { frame, loaded } = (await seen.jsonValue())!;
    expect(frame).toBeGreaterThan(loaded);
    await expect(picture).toHaveCount(0);
    const inner = (await page.locator('iframe').elementHandle())!;
    const framed = await (await inner.contentFrame())!.evaluate(() =>
      performance.getEntriesByType('resource').map(({ name }) => name),
    );
    expect(framed.filter((name) => /\/three-[^/]*\.js$/.test(name))).toEqual([]);
    // those of pages that links lead to are fetched later
    const bytes = await page.evaluate(
      (until) =>
        performance
          .getEntriesByType('resource')
          .filter(({ name, startTime }) => name.endsWith('.js') && startTime < until)
          .reduce((sum, entry) => sum + (entry as PerformanceResourceTiming).decodedBodySize, 0),
      loaded,
    );
    expect(bytes, 'scripts of the page').toBeLessThan(250_000);
  });

  test('a live module loads near the view, shows its code, and rests out of view @verify', async ({ page, site }) => {
    await page.setViewportSize({ width: 1000, height: 300 });
    await page.goto(`${site}techniques/deferred.html`);
    const frame = page.locator('iframe');
    await expect(frame).toHaveCount(0);
    await page.getByRole('button', { name: 'Show the code' }).click();
    await expect(page.locator('.live-code')).toContainText('new FarolRenderer(webgl');
    await page.getByRole('heading', { name: 'Step by step' }).scrollIntoViewIfNeeded();
    await expect(frame).toHaveCount(1);
    const draws = (): Promise<number> =>
      page.evaluate(async () => {
        const { live } = document.querySelector('iframe')!.contentWindow as unknown as LiveWindow;
        return (await (await live).farol).info.drawCalls;
      });
    await frame.scrollIntoViewIfNeeded();
    await expect.poll(draws).toBeGreaterThan(0);
    await page.evaluate(() => {
      const inner = document.querySelector('iframe')!.contentWindow!;
      Object.assign(window, { frames: 0 });
      const count = (): void => {
        (window as unknown as { frames: number }).frames++;
        inner.requestAnimationFrame(count);
      };
      inner.requestAnimationFrame(count);
    });
    const frames = (): Promise<number> => page.evaluate(() => (window as unknown as { frames: number }).frames);
    await expect.poll(frames).toBeGreaterThan(1);
    // an observer of ours is told after the page's own
    await page.evaluate(
      () =>
        new Promise<void>((resolve) => {
          const box = document.querySelector('.live')!;
          new IntersectionObserver((entries) => entries.at(-1)!.isIntersecting || resolve()).observe(box);
          scrollTo(0, document.body.scrollHeight);
        }),
    );
    const resting = await page.evaluate(
      () =>
        new Promise<[number, number]>((resolve) => {
          const { frames } = window as unknown as { frames: number };
          let left = 5;
          const later = (): void => {
            if (--left > 0) requestAnimationFrame(later);
            else resolve([frames, (window as unknown as { frames: number }).frames]);
          };
          requestAnimationFrame(later);
        }),
    );
    expect(resting[1] - resting[0]).toBeLessThanOrEqual(1);
  });

  test('microshaders of the gallery are edited, as packages have them, and what does not compile says why @verify', async ({
    page,
    site,
    watch,
  }) => {
    await page.goto(`${site}live/index.html?gallery/attenuation-edited-live`);
    await page.getByLabel('Attenuation, GLSL').fill('float falloff = 0.7 * ;');
    await expect(page.locator('output')).toContainText('syntax error');
    await page.getByLabel('Begin with').selectOption('Straight');
    await expect(page.locator('output')).toBeEmpty();
    watch.forgive(/syntax error/);
    await page.goto(`${site}live/index.html?gallery/microshader-toon`);
    const edited = page.evaluate(async () => {
      const { live } = window as unknown as LiveWindow;
      return (await (await live).farol).microshaders.get('shadeSurface')!.header;
    });
    expect(await edited).toContain('example_bands(s.diffuse)');
  });

  test('the API is in the navigation and found by name, with an example and a link to the source @verify', async ({
    page,
    site,
  }) => {
    await page.goto(`${site}start.html`);
    await page.getByRole('navigation', { name: 'Main Navigation' }).getByRole('link', { name: 'API' }).click();
    await expect(page).toHaveURL(`${site}api/`);
    await page.keyboard.press('Control+k');
    await page.getByRole('searchbox').fill('LightField');
    await expect(page.locator('.result').first()).toHaveAttribute('href', /renderer-light-field\.html#LightField$/);
    await page.keyboard.press('Enter');
    await expect(page).toHaveURL(`${site}api/renderer-light-field.html#LightField`);
    await expect(page.locator('.vp-doc')).toContainText('new LightField(10_000)');
    const source = page.getByRole('link', { name: 'source', exact: true }).first();
    await expect(source).toHaveAttribute('href', /\/blob\/main\/packages\/renderer\/src\/light-fields\//);
  });

  test('a page that is not there has the styles and bars of the site, in any folder of it @verify', async ({
    page,
    site,
    watch,
  }) => {
    const body = readFileSync(join(siteFolder, '404.html'), 'utf8');
    // as hosts of static files answer
    for (const path of ['none.html', 'guides/attempts/none/deeper.html']) {
      await page.route(site + path, (route) => route.fulfill({ status: 404, contentType: 'text/html', body }));
      await page.goto(site + path);
      const bar = page.getByRole('navigation', { name: 'Main Navigation' });
      await expect(bar.getByRole('link', { name: 'Techniques' })).toHaveAttribute('href', /\/a-folder\/techniques\/$/);
      await expect(page.getByText('PAGE NOT FOUND')).toBeVisible();
      expect(await page.evaluate(() => getComputedStyle(document.body).fontFamily)).toContain('system-ui');
    }
    watch.forgive(/404/);
  });

  test('gives machines its texts @verify', async ({ request, site }) => {
    const list = await (await request.get(`${site}llms.txt`)).text();
    expect(list).toMatch(/^# Farol\n\n> /);
    const links = [...list.matchAll(/\]\((.*?)\)/g)].map(([, link]) => link);
    expect(links.length).toBeGreaterThan(50);
    for (const link of links) expect((await request.get(site + link)).status(), link).toBe(200);
    const all = await (await request.get(`${site}llms-full.txt`)).text();
    expect(all).toContain('# Get started in a minute');
    expect(all).toContain('\n## LightField\n');
  });
});
