import { expect, test } from '../support/test';

test.beforeEach(async ({ page, pagesURL }) => {
  await page.goto(pagesURL);
  await page.waitForFunction(() => 'testPage' in window);
});

test('what the device or the caller lacks is named with the mend', async ({ page }) => {
  const messages = await page.evaluate(() => {
    const { farol, three } = window.testPage;
    const message = (action: () => unknown) => {
      try {
        action();
        return 'no error';
      } catch (error) {
        return (error as Error).message;
      }
    };
    const webgl = new three.WebGLRenderer();
    const gl = webgl.getContext() as WebGL2RenderingContext;
    const good = new farol.FarolRenderer(webgl);
    const without = (names: string[], action: () => unknown) => {
      const { getExtension } = gl;
      gl.getExtension = ((name: string) =>
        names.includes(name) ? null : getExtension.call(gl, name as 'OCULUS_multiview')) as never;
      const result = message(action);
      gl.getExtension = getExtension;
      return result;
    };
    const floats = ['EXT_color_buffer_float', 'EXT_color_buffer_half_float'];
    const fewBuffers = () => {
      const { getParameter } = gl;
      gl.getParameter = ((name: number) =>
        name === gl.MAX_DRAW_BUFFERS ? 2 : (getParameter.call(gl, name) as unknown)) as never;
      const result = message(() => new farol.GBuffer(webgl));
      gl.getParameter = getParameter;
      return result;
    };
    return {
      technique: message(() => (good.technique = 'raytraced' as never)),
      view: message(() => (good.view = 'smell' as never)),
      option: message(() => new farol.FarolRenderer(webgl, { technique: 'x' as never })),
      webgl2: message(() => new farol.FarolRenderer({ getContext: () => ({}) } as never)),
      floats: without(floats, () => new farol.FarolRenderer(webgl, { technique: 'deferred' })),
      floatsNotNeeded: without(floats, () => new farol.FarolRenderer(webgl, { technique: 'forward-single-pass' })),
      attachments: fewBuffers(),
      count: message(() => new farol.WebGLMultipleRenderTargets(4, 4, 0)),
      xr: message(() => {
        webgl.xr.isPresenting = true;
        good.render(new three.Scene(), new three.PerspectiveCamera());
      }),
      disposed: message(() => {
        webgl.xr.isPresenting = false;
        good.dispose();
        good.render(new three.Scene(), new three.PerspectiveCamera());
      }),
    };
  });
  expect(messages.technique).toMatch(/unknown technique "raytraced"; use one of: .*forward.*deferred/);
  expect(messages.view).toMatch(/unknown view "smell"; use one of: final, albedo/);
  expect(messages.option).toContain('unknown technique "x"');
  expect(messages.webgl2).toMatch(/needs WebGL 2; make the WebGLRenderer/);
  expect(messages.floats).toMatch(/no float colour buffers .*forward-single-pass/);
  expect(messages.floatsNotNeeded).toBe('no error');
  expect(messages.attachments).toMatch(/4 attachments and this device draws to 2 at once; use a technique without/);
  expect(messages.count).toMatch(/count is 0; give a whole number/);
  expect(messages.xr).toMatch(/XR sessions are not supported; draw them with webgl.render/);
  expect(messages.disposed).toMatch(/after dispose\(\); make a new/);
});

test('a light that is not a number is named once, left out, and the picture stays', async ({ page, watch }) => {
  const { largest, visible } = await page.evaluate(() => {
    const { Bench, compareImages, materialScene, three } = window.testPage;
    const bench = new Bench(64, 48);
    const { scene, camera } = materialScene(64, 48, { count: 4, onlyDeferred: true });
    const before = bench.byTechnique('deferred', scene, camera);
    const visible = bench.farol.info.lights.visible;
    const broken = new three.PointLight(0xffffff, NaN, 5);
    broken.name = 'lamp by the door';
    scene.add(broken);
    let largest = 0;
    for (let i = 0; i < 3; i++) {
      largest = Math.max(largest, compareImages(before, bench.byTechnique('deferred', scene, camera)).largest);
    }
    return { largest, visible: bench.farol.info.lights.visible - visible };
  });
  expect(watch.forgive(/"lamp by the door".*not a finite number/)).toBe(1);
  expect(largest).toBe(0);
  expect(visible).toBe(0);
});

test('what has no finite place, or a shader that does not compile, is named; the rest is drawn as by stock three', async ({
  page,
  watch,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, compareImages, farol, materialScene, three } = window.testPage;
    const bench = new Bench(64, 48);
    const { scene, camera } = materialScene(64, 48, { count: 4, onlyDeferred: true });
    const lost = new three.Mesh(new three.BoxGeometry(), new three.MeshStandardMaterial());
    lost.name = 'lost box';
    lost.position.x = NaN;
    const broken = new three.Mesh(
      new three.BoxGeometry(),
      new three.ShaderMaterial({ name: 'broken shader', fragmentShader: 'void main() { gl_FragColor = vec3(1.0); }' }),
    );
    const patched = new three.MeshStandardMaterial({ name: 'broken patch' });
    patched.onBeforeCompile = (shader) => {
      shader.fragmentShader = shader.fragmentShader.replace('void main() {', 'void main() { nonsense();');
    };
    const without = (['forward-single-pass', 'deferred', 'light-prepass'] as const).map((technique) => [
      technique,
      bench.byTechnique(technique, scene, camera),
    ] as const); // prettier-ignore
    scene.add(lost, broken, new three.Mesh(new three.SphereGeometry(), patched));
    void farol;
    // an error of the device is what a broken program gives, in stock three as well
    const gl = bench.webgl.getContext();
    gl.getError = () => 0;
    return without.map(([technique, before]) => {
      let largest = 0;
      for (let i = 0; i < 2; i++)
        largest = Math.max(largest, compareImages(before, bench.byTechnique(technique, scene, camera)).largest);
      return { technique, largest };
    });
  });
  for (const { technique, largest } of results) expect(largest, technique).toBe(0);
  expect(watch.forgive(/"lost box" has a matrix or positions that are not numbers/)).toBe(1);
  expect(watch.forgive(/Material Name: broken shader/)).toBeGreaterThan(0);
  expect(watch.forgive(/Material Name: broken patch/)).toBeGreaterThan(0);
  watch.forgive(/useProgram: program not valid|INVALID_OPERATION|too many errors/);
});
