import { expect, test } from '../support/benchTest';

/**
 * Thin and transparent things that lie on lit surfaces, in multisampled targets and on canvases with `antialias`: tested
 * against the depth of samples, not of pixels. Techniques that shade a G-buffer have no smooth edges of lit surfaces, which
 * the surfaces here leave outside of the picture.
 */
test('lines, wireframes, points, sprites and glass on lit surfaces in multisampled pictures: as in stock three', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, compareImages, techniquesInTurn, three } = window.testPage;
    const [width, height] = [96, 64];
    const scene = new three.Scene();
    scene.background = new three.Color(0x203040);
    const camera = new three.PerspectiveCamera(50, width / height, 0.1, 30);
    camera.position.set(0, 2, 3);
    camera.lookAt(0, 0, -1);
    // waves that fill the picture, seen at all slopes
    const waves = new three.PlaneGeometry(16, 16, 24, 24);
    const { position } = waves.attributes;
    for (let i = 0; i < position.count; i++) {
      position.setZ(i, 0.4 * Math.sin(2.1 * position.getX(i)) * Math.cos(1.7 * position.getY(i)));
    }
    waves.computeVertexNormals();
    const ground = new three.Mesh(waves, new three.MeshStandardMaterial({ color: 0x889988, roughness: 0.6 }));
    ground.rotation.x = -Math.PI / 2;
    scene.add(ground, new three.AmbientLight(0xffffff, 0.3));
    for (let i = 0; i < 4; i++) {
      const light = new three.PointLight(0xffeedd, 6, 9);
      light.position.set(2 * Math.cos(i * 1.6), 1.6, 2 * Math.sin(i * 1.6) - 1);
      scene.add(light);
    }
    const glass = { color: 0x3366ff, transparent: true, opacity: 0.5 };
    const things: Record<string, InstanceType<typeof three.Object3D>> = {
      wireframe: new three.Mesh(waves, new three.MeshBasicMaterial({ color: 0xff4400, wireframe: true })),
      lines: new three.LineSegments(
        new three.WireframeGeometry(waves),
        new three.LineBasicMaterial({ color: 0x00ffff }),
      ),
      points: new three.Points(waves, new three.PointsMaterial({ color: 0xffff00, size: 0.08 })),
      glass: new three.Mesh(waves, new three.MeshBasicMaterial(glass)),
      'lit glass': new three.Mesh(waves, new three.MeshStandardMaterial(glass)),
    };
    for (const thing of Object.values(things)) ground.add(thing);
    const sprite = new three.Sprite(new three.SpriteMaterial({ color: 0xff00ff }));
    sprite.position.set(0.3, 0.1, 0);
    scene.add(sprite);
    things.sprite = sprite;
    const bench = new Bench(width, height, { samples: 4 });
    const { webgl: canvas, farol: canvasFarol } = new Bench(width, height, { renderer: { antialias: true } });
    const read = (draw: () => void) => {
      draw();
      const gl = canvas.getContext();
      const bytes = new Uint8Array(width * height * 4);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
      return { width, height, data: Float32Array.from(bytes, (byte) => (byte / 255) ** 2.2) };
    };
    const found: { name: string; psnr: number }[] = [];
    for (const [shown, thing] of Object.entries(things)) {
      for (const other of Object.values(things)) other.visible = other === thing;
      const stock = bench.stock(scene, camera);
      const stockCanvas = read(() => canvas.render(scene, camera));
      for (const technique of techniquesInTurn(3)) {
        if (technique === 'inferred') continue; // no light at the resolution of lines
        const { psnr } = compareImages(stock, bench.byTechnique(technique, scene, camera));
        found.push({ name: `${shown}, ${technique}, target`, psnr });
        canvasFarol.technique = technique;
        const onCanvas = compareImages(
          stockCanvas,
          read(() => canvasFarol.render(scene, camera)),
        );
        found.push({ name: `${shown}, ${technique}, canvas`, psnr: onCanvas.psnr });
      }
    }
    return found;
  });
  for (const { name, psnr } of results) {
    // shaded once a pixel: by a G-buffer, a light buffer, or sums that are resolved
    const resolved = /deferred|light-prepass|forward, /.test(name) && !/(tiled|clustered)-forward/.test(name);
    expect.soft(psnr, name).toBeGreaterThan(resolved ? 45 : 100);
  }
});
