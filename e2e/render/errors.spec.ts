import { expect, test } from '../support/benchTest';

test('what the device or the caller lacks is named with the mend', async ({ benchPage: page }) => {
  const messages = await page.evaluate(() => {
    const { authoring, farol, three } = window.testPage;
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
    /** A renderer of its own, since three asks a context once. */
    const withoutFloats = (technique: 'deferred' | 'forward-single-pass') => {
      const canvas = document.createElement('canvas');
      const context = canvas.getContext('webgl2')!;
      const getExtension = context.getExtension.bind(context) as (name: string) => unknown;
      context.getExtension = ((name: string) =>
        name.startsWith('EXT_color_buffer') ? null : getExtension(name)) as never;
      const lacking = new three.WebGLRenderer({ canvas, context });
      const result = message(() => new farol.FarolRenderer(lacking, { technique }));
      lacking.dispose();
      return result;
    };
    const fewBuffers = () => {
      const { getParameter } = gl;
      gl.getParameter = ((name: number) =>
        name === gl.MAX_DRAW_BUFFERS ? 2 : (getParameter.call(gl, name) as unknown)) as never;
      const result = message(() => new authoring.GBuffer(webgl));
      gl.getParameter = getParameter;
      return result;
    };
    return {
      technique: message(() => (good.technique = 'raytraced' as never)),
      view: message(() => (good.view = 'smell' as never)),
      option: message(() => new farol.FarolRenderer(webgl, { technique: 'x' as never })),
      webgl2: message(() => new farol.FarolRenderer({ getContext: () => ({}) } as never)),
      floats: withoutFloats('deferred'),
      floatsNotNeeded: withoutFloats('forward-single-pass'),
      attachments: fewBuffers(),
      count: message(() => new authoring.WebGLMultipleRenderTargets(4, 4, 0)),
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
  expect(messages.webgl2).toMatch(/needs a WebGLRenderer with WebGL 2, not a WebGPURenderer/);
  expect(messages.floats).toMatch(/no float colour buffers .*forward-single-pass/);
  expect(messages.floatsNotNeeded).toBe('no error');
  expect(messages.attachments).toMatch(/4 attachments and this device draws to 2 at once; use a technique without/);
  expect(messages.count).toMatch(/count is 0; give a whole number/);
  expect(messages.disposed).toMatch(/after dispose\(\); make a new/);
});

test('a light that is not a number is named once, left out, and the picture stays', async ({
  benchPage: page,
  watch,
}) => {
  const { largest, visible } = await page.evaluate(() => {
    const { Bench, compareImages, fewMeshes, materialScene, three } = window.testPage;
    const bench = new Bench(64, 48);
    const { scene, camera } = materialScene(64, 48, { count: 4, onlyDeferred: true, part: fewMeshes });
    const before = bench.byTechnique('deferred', scene, camera);
    const visible = bench.farol.info.lights.visible;
    const broken = new three.PointLight(0xffffff, NaN, 5);
    broken.name = 'lamp by the door';
    const aimless = new three.DirectionalLight();
    aimless.name = 'sun';
    aimless.target.position.x = NaN;
    const sky = new three.HemisphereLight(0xffffff, 0x00ff00);
    sky.groundColor.g = NaN;
    sky.name = 'sky';
    const panel = new three.RectAreaLight(0xffffff, 1, 2, 2);
    panel.quaternion.x = NaN;
    panel.name = 'panel';
    scene.add(broken, aimless, aimless.target, sky, panel);
    let largest = 0;
    for (let i = 0; i < 3; i++) {
      largest = Math.max(largest, compareImages(before, bench.byTechnique('deferred', scene, camera)).largest);
    }
    return { largest, visible: bench.farol.info.lights.visible - visible };
  });
  expect(watch.forgive(/"lamp by the door".*not a finite number/)).toBe(1);
  for (const name of ['sun', 'sky', 'panel'])
    expect(watch.forgive(new RegExp(`"${name}".*not a finite number`)), name).toBe(1);
  expect(largest).toBe(0);
  expect(visible).toBe(0);
});

test('what has no finite place, or a shader that does not compile, is named; the rest is drawn as by stock three', async ({
  benchPage: page,
  watch,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, compareImages, farol, fewMeshes, materialScene, three } = window.testPage;
    const bench = new Bench(64, 48);
    const { scene, camera } = materialScene(64, 48, { count: 4, onlyDeferred: true, part: fewMeshes });
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
    const results = without.map(([technique, before]) => {
      let largest = 0;
      for (let i = 0; i < 2; i++)
        largest = Math.max(largest, compareImages(before, bench.byTechnique(technique, scene, camera)).largest);
      return { technique, largest };
    });
    // a camera is named, and not what it sees
    for (const [name, value] of Object.entries({ fov: NaN, aspect: NaN, x: NaN })) {
      const eye = camera.clone();
      eye.name = `eye without ${name}`;
      if (name === 'x') eye.position.x = value;
      else Object.assign(eye, { [name]: value });
      (eye as { updateProjectionMatrix?(): void }).updateProjectionMatrix?.();
      for (let i = 0; i < 2; i++) bench.byTechnique('forward-single-pass', scene, eye);
    }
    return results;
  });
  for (const { technique, largest } of results) expect(largest, technique).toBe(0);
  expect(watch.forgive(/"lost box" has NaN in its matrix, positions, fov or aspect/)).toBe(1);
  for (const name of ['fov', 'aspect', 'x']) expect(watch.forgive(new RegExp(`"eye without ${name}" has`))).toBe(1);
  expect(watch.forgive(/Material Name: broken shader/)).toBeGreaterThan(0);
  expect(watch.forgive(/Material Name: broken patch/)).toBeGreaterThan(0);
  watch.forgive(/useProgram: program not valid|INVALID_OPERATION|too many errors/);
});

test('a geometry with normals of zero length, and light beyond half floats, are drawn as by stock three', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, effects, techniquesInTurn, three } = window.testPage;
    const [width, height] = [64, 48];
    const { webgl, farol: renderer } = new Bench(width, height);
    webgl.toneMapping = three.ACESFilmicToneMapping;
    const gl = webgl.getContext();
    const camera = new three.PerspectiveCamera(50, width / height, 0.1, 50);
    camera.position.z = 5;
    const scene = new three.Scene();
    const lamp = new three.PointLight(0xffffff, 5, 20);
    lamp.position.set(0, 1, 3);
    scene.add(lamp, new three.AmbientLight(0xffffff, 0.5));
    const without = new three.SphereGeometry(0.8);
    (without.attributes.normal.array as Float32Array).fill(0);
    const glowing = new three.MeshStandardMaterial({ emissive: 0xffffff, emissiveIntensity: 1e6 });
    [
      new three.Mesh(without, new three.MeshStandardMaterial()),
      new three.Mesh(without, new three.MeshLambertMaterial()),
      new three.Mesh(new three.SphereGeometry(0.8), glowing),
    ].forEach((mesh, i) => scene.add(mesh.translateX(1.8 * (i - 1))));
    const read = () => {
      const data = new Uint8Array(width * height * 4);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
      return data;
    };
    webgl.render(scene, camera);
    const stock = read();
    const occlusion = new effects.AmbientOcclusion();
    return techniquesInTurn(0).flatMap((technique) =>
      (technique === 'deferred' ? [[], [occlusion]] : [[]]).map((list) => {
        renderer.technique = technique;
        renderer.effects = list;
        renderer.render(scene, camera);
        const off = read().filter((value, i) => Math.abs(value - stock[i]) > 8).length / stock.length;
        return { name: `${technique}, ${list.length} effects`, off };
      }),
    );
  });
  // inferred lighting is smooth at outlines
  for (const { name, off } of results) expect(off, name).toBeLessThan(name.startsWith('inferred') ? 0.05 : 0.002);
});
