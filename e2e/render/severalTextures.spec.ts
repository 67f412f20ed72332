import { expect, test } from '../support/benchTest';

for (const samples of [0, 4]) {
  test(`a target with several textures, ${samples} samples: each as by stock three, without an error`, async ({
    benchPage: page,
  }) => {
    const results = await page.evaluate((samples) => {
      const { Bench, compareImages, techniquesInTurn, three } = window.testPage;
      const { webgl, farol: renderer } = new Bench(64, 48);
      const gl = webgl.getContext() as WebGL2RenderingContext;
      const target = new three.WebGLRenderTarget(64, 48, { count: 3, type: three.HalfFloatType, samples });
      const scene = new three.Scene();
      scene.background = new three.Color(0x102030);
      const camera = new three.PerspectiveCamera(50, 64 / 48, 0.1, 20);
      camera.position.z = 4;
      // made first, and so drawn first by stock three too: what the other textures have behind it hangs on that
      const standard = new three.MeshStandardMaterial();
      const several = new three.RawShaderMaterial({
        glslVersion: three.GLSL3,
        vertexShader: `in vec3 position; in vec3 normal; uniform mat4 modelViewMatrix, projectionMatrix;
          uniform mat3 normalMatrix; out vec3 n;
          void main() { n = normalize(normalMatrix * normal); gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`,
        fragmentShader: `precision highp float; in vec3 n; layout(location = 0) out vec4 color;
          layout(location = 1) out vec4 normal; layout(location = 2) out vec4 depth;
          void main() { color = vec4(1.0, n.z, 0.2, 1.0); normal = vec4(n, 1.0); depth = vec4(gl_FragCoord.z); }`,
      });
      scene.add(new three.Mesh(new three.TorusKnotGeometry(0.8, 0.3, 64, 12), several));
      const light = new three.PointLight(0xffffff, 20);
      light.position.set(1, 2, 3);
      scene.add(light);
      const lit = new three.Mesh(new three.SphereGeometry(0.4), standard);
      lit.position.set(0.4, 0, 1.4);
      // where stock three leaves it to WebGL, which refuses a shader that does not write all that is drawn to
      const { onBeforeRender, onAfterRender } = lit;
      const drawsFirst = (on: boolean) => {
        const all = [gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT0 + 1, gl.COLOR_ATTACHMENT0 + 2];
        lit.onBeforeRender = on ? () => gl.drawBuffers([gl.COLOR_ATTACHMENT0]) : onBeforeRender;
        lit.onAfterRender = on ? () => gl.drawBuffers(all) : onAfterRender;
      };
      const read = () =>
        target.textures.map((_, i) => {
          const halves = new Uint16Array(64 * 48 * 4);
          webgl.readRenderTargetPixels(target, 0, 0, 64, 48, halves, undefined, i);
          return {
            width: 64,
            height: 48,
            data: Float32Array.from(halves, (half) => three.DataUtils.fromHalfFloat(half)),
          };
        });
      const draw = (render: () => void) => {
        webgl.setRenderTarget(target);
        webgl.clear();
        while (gl.getError() !== 0);
        render();
        webgl.setRenderTarget(null);
        return { error: gl.getError(), images: read() };
      };
      return [false, true].flatMap((withLit) => {
        if (withLit) scene.add(lit);
        drawsFirst(true);
        const stock = draw(() => webgl.render(scene, camera));
        drawsFirst(false);
        return [
          { name: 'stock three', error: stock.error, differences: [] as number[] },
          ...techniquesInTurn(samples).map((technique) => {
            renderer.technique = technique;
            const { error, images } = draw(() => renderer.render(scene, camera));
            const differences = images.map((image, i) => compareImages(image, stock.images[i]).psnr);
            return { name: `${technique}${withLit ? ', something lit' : ''}`, error, differences };
          }),
        ];
      });
    }, samples);
    for (const { name, error, differences } of results) {
      expect.soft(error, name).toBe(0);
      // what is lit and shaded after it is resolved has no smooth edges
      if (samples > 0 && name.includes('lit')) continue;
      const least = name.startsWith('inferred') ? 35 : 60;
      for (const psnr of differences) expect.soft(psnr, name).toBeGreaterThan(least);
    }
  });
}

test('effects in a target with several textures: those that take the picture over are left out, with one warning each', async ({
  benchPage: page,
  watch,
}) => {
  const { error, same } = await page.evaluate(() => {
    const { Bench, compareImages, effects, fewMeshes, materialScene, three } = window.testPage;
    const { webgl, farol } = new Bench(64, 48);
    const target = new three.WebGLRenderTarget(64, 48, { count: 2, type: three.HalfFloatType });
    const { scene, camera } = materialScene(64, 48, { count: 2, onlyDeferred: true, part: fewMeshes });
    farol.technique = 'deferred';
    const draw = () => {
      webgl.setRenderTarget(target);
      for (let i = 0; i < 2; i++) farol.render(scene, camera);
      const halves = new Uint16Array(64 * 48 * 4);
      webgl.readRenderTargetPixels(target, 0, 0, 64, 48, halves);
      webgl.setRenderTarget(null);
      return { width: 64, height: 48, data: Float32Array.from(halves, (half) => three.DataUtils.fromHalfFloat(half)) };
    };
    const plain = draw();
    farol.effects = [new effects.TAA(), new effects.SMAA(), new effects.WeightedBlendedOIT(), new effects.Decals()];
    return { same: compareImages(plain, draw()).largest, error: webgl.getContext().getError() };
  });
  expect([same, error]).toEqual([0, 0]);
  expect(watch.forgive(/is left out, since the target has several textures/)).toBe(3);
});
