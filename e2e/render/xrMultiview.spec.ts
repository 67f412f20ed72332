import type { Page } from '@playwright/test';
import { expect, test } from '../support/test';

// the layer of the emulated headset is as large as the window
test.use({ viewport: { width: 192, height: 96 } });

async function open(page: Page, pagesURL: string): Promise<void> {
  await page.goto(`${pagesURL}xr.html`);
  await page.waitForFunction(() => 'xrPage' in window);
}

for (const technique of ['clustered-forward', 'forward-single-pass'] as const)
  test(`both eyes drawn at once by ${technique} are the pictures of the eyes, by half of the draws @verify`, async ({
    page,
    pagesURL,
    watch,
  }) => {
    await open(page, pagesURL);
    const results = await page.evaluate(async (technique) => {
      const { XRBench, compareImages, countDraws, device, eyeOf, isFlat, multiviewScene } = window.xrPage;
      const bench = new XRBench();
      const { farol, webgl } = bench;
      webgl.shadowMap.enabled = true;
      await bench.start('immersive-vr');
      const { scene, camera } = multiviewScene();
      device.position.set(0.1, 1.5, 0.2);
      device.quaternion.set(-0.1, 0.05, 0, Math.sqrt(1 - 0.0125));
      device.ipd = 1.2;
      const draw = async (multiview: boolean) => {
        farol.multiview = multiview;
        await bench.settle(technique, scene, camera);
        return bench.frame(() => {
          let picture = bench.layer(() => farol.render(scene, camera));
          const draws = countDraws(webgl.getContext() as WebGL2RenderingContext, () => {
            picture = bench.layer(() => farol.render(scene, camera));
          });
          return { picture, draws, names: farol.info.passes.map(({ name }) => name) };
        });
      };
      const eyes = await draw(false);
      const both = await draw(true);
      await bench.loseContext();
      const back = await draw(true);
      await bench.end();
      return {
        lost: compareImages(both.picture, back.picture).largest,
        draws: [eyes.draws, both.draws],
        names: [eyes.names, both.names],
        eyes: ([0, 1] as const).map((eye) => ({
          flat: isFlat(eyeOf(eyes.picture, eye)),
          ...compareImages(eyeOf(eyes.picture, eye), eyeOf(both.picture, eye)),
        })),
        apart: compareImages(eyeOf(both.picture, 0), eyeOf(both.picture, 1)).psnr,
      };
    }, technique);
    const [eyes, both] = results.names;
    expect(eyes).toContain('opaque, eye 2');
    expect(both).toContain('opaque');
    expect(both.filter((name) => name.endsWith('eye 2'))).toEqual([]);
    // one more writes both eyes to the layer
    expect(results.draws[1]).toBeLessThanOrEqual(results.draws[0] / 2 + 1);
    for (const [eye, { flat, psnr, share }] of results.eyes.entries()) {
      expect(flat).toBe(false);
      expect.soft(psnr, `eye ${eye}`).toBeGreaterThan(80);
      expect.soft(share, `eye ${eye}`).toBeLessThan(0.0005);
    }
    expect(results.apart).toBeLessThan(30);
    expect(results.lost).toBe(0);
    // the emulator clears its framebuffer whether or not there is a context
    watch.forgive(/context|at onDeviceFrame/i);
  });

test('what cannot be drawn for both eyes at once is drawn eye by eye, with the same picture @verify', async ({
  page,
  pagesURL,
}) => {
  await open(page, pagesURL);
  const results = await page.evaluate(async () => {
    const { XRBench, compareImages, device, effects, multiviewScene, three } = window.xrPage;
    const bench = new XRBench();
    const { farol } = bench;
    await bench.start('immersive-vr');
    device.ipd = 1.2;
    const ball = (material: InstanceType<typeof three.Material>) => {
      const mesh = new three.Mesh(new three.SphereGeometry(0.3), material);
      mesh.position.set(0, 1.6, 2);
      return mesh;
    };
    const plain = () => new three.MeshStandardMaterial();
    const cases = {
      'own shader': () =>
        ball(
          new three.ShaderMaterial({
            vertexShader: 'void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }',
            fragmentShader: 'void main() { gl_FragColor = vec4(1.0, 0.5, 0.0, 1.0); }',
          }),
        ),
      transmission: () => ball(new three.MeshPhysicalMaterial({ transmission: 1 })),
      'one eye': () => {
        const mesh = ball(plain());
        mesh.layers.set(1);
        return mesh;
      },
      callback: () => {
        const mesh = ball(plain());
        mesh.onBeforeRender = () => mesh.name.length;
        return mesh;
      },
      sprite: () => new three.Sprite(),
      effect: () => ball(plain()),
    };
    const found = [];
    for (const [name, make] of Object.entries(cases)) {
      const { scene, camera } = multiviewScene();
      scene.add(make());
      farol.effects = name === 'effect' ? [new effects.SMAA()] : [];
      const draw = async (multiview: boolean) => {
        farol.multiview = multiview;
        await bench.settle('clustered-forward', scene, camera);
        return bench.frame(() => bench.layer(() => farol.render(scene, camera)));
      };
      const apart = await draw(false);
      const asked = await draw(true);
      found.push({ name, eyes: farol.info.passes.length, largest: compareImages(apart, asked).largest });
    }
    await bench.end();
    return found;
  });
  for (const { name, largest } of results) expect.soft(largest, name).toBe(0);
});
