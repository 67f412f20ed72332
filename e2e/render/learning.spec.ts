import { expect, test } from '../support/benchTest';

test("'auto' unlearns a rule that is wrong on the GPU at hand, by trials that compile nothing and look the same, and keeps what it learnt @verify", async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate(async () => {
    const { Bench, farol: package_, three } = window.testPage;
    await package_.FarolRenderer.preload();
    await package_.clearLearnt();
    const scene = new three.Scene();
    const material = new three.MeshStandardMaterial({ color: 0xccbbaa });
    for (let i = 0; i < 10; i++) {
      const ball = new three.Mesh(new three.SphereGeometry(0.3), material);
      ball.position.set(i % 4, Math.floor(i / 4), 0);
      scene.add(ball);
    }
    for (let i = 0; i < 6; i++) {
      const lamp = new three.PointLight(0xffeedd, 3, 20);
      lamp.position.set(i, 1, 2);
      scene.add(lamp);
    }
    const camera = new three.PerspectiveCamera(50, 1, 0.1, 30);
    camera.position.set(1.5, 1, 5);

    /** A renderer on a simulated GPU: its timer says that deferred techniques take `deferred` ms, and others 1000. */
    const makeBench = (deferred: number, learning = true, timing = false) => {
      const bench = new Bench(64, 64);
      const { farol, webgl } = bench;
      const gl = webgl.getContext() as WebGL2RenderingContext;
      const extension = { TIME_ELAPSED_EXT: 1, GPU_DISJOINT_EXT: 2 };
      const techniques = new Map<object, string>();
      const fresh: object[] = [];
      const { getExtension, getParameter } = gl;
      let queries = 0;
      let current: object | null = null;
      Object.assign(gl, {
        getExtension: (name: string) =>
          name === 'EXT_disjoint_timer_query_webgl2' ? extension : getExtension.call(gl, name as 'OCULUS_multiview'),
        getParameter: (name: number) => (name === 2 ? false : getParameter.call(gl, name)),
        getQuery: () => current,
        createQuery: () => ({}),
        deleteQuery() {},
        beginQuery(_: number, query: object) {
          queries++;
          techniques.delete(query);
          fresh.push((current = query));
        },
        endQuery: () => void (current = null),
        getQueryParameter: (query: object, name: number) =>
          name === gl.QUERY_RESULT_AVAILABLE
            ? techniques.has(query)
            : (techniques.get(query)!.endsWith('deferred') ? deferred : 1000) * 1e6,
      });
      Object.assign(farol, { learning, timing });
      const draw = () => {
        const picture = bench.draw(() => farol.render(scene, camera)).data;
        for (const query of fresh.splice(0)) techniques.set(query, farol.info.technique);
        return { picture, technique: farol.info.technique as string, reason: farol.info.reason };
      };
      return { bench, draw, isOpen: () => current !== null, queries: () => queries };
    };

    /** Draws until `until` is true of a frame. */
    const drawUntil = async (
      { bench, draw }: ReturnType<typeof makeBench>,
      until: (frame: ReturnType<typeof draw>) => boolean,
    ) => {
      const found = { frames: 0, trials: 0, compiled: 0, difference: 0, first: '', last: '' };
      let before = draw();
      found.first = before.technique;
      for (let frame = before; !until(frame); before = frame) {
        // lets programs link
        const { port1, port2 } = new MessageChannel();
        await new Promise((resolve) => {
          port1.addEventListener('message', resolve, { once: true });
          port1.start();
          port2.postMessage(null);
        });
        port1.close();
        const programs = new Set(bench.webgl.info.programs);
        frame = draw();
        found.frames++;
        found.last = frame.technique;
        if (!frame.reason.startsWith('measured')) continue;
        found.trials++;
        found.compiled += bench.webgl.info.programs!.filter((program) => !programs.has(program)).length;
        for (let i = 0; i < frame.picture.length; i++)
          found.difference = Math.max(found.difference, Math.abs(frame.picture[i] - before.picture[i]));
      }
      return found;
    };

    const isLearnt = ({ reason }: { reason: string }) => reason.startsWith('learnt on this GPU');
    const byPass = await drawUntil(makeBench(2000, true, true), isLearnt);
    await package_.clearLearnt();
    const slow = makeBench(2000);
    const learnt = await drawUntil(slow, isLearnt);
    const isOpen = slow.isOpen();
    const kept = localStorage.getItem('farol-learnt');
    const again = await drawUntil(makeBench(2000), isLearnt);
    const off = makeBench(2000, false);
    const byRule = await drawUntil(off, () => off.bench.farol.info.technique !== '');
    await package_.clearLearnt();
    const cleared = localStorage.getItem('farol-learnt');
    const back = await drawUntil(slow, ({ technique }) => technique === 'clustered-deferred');
    return { byPass, learnt, isOpen, kept, again, byRule, queriesOff: off.queries(), cleared, back };
  });
  const { byPass, learnt, again } = seen;
  for (const [name, found] of Object.entries({ byPass, learnt })) {
    expect([found.first, found.last], name).toEqual(['clustered-deferred', 'clustered-forward']);
    expect(found.trials, name).toBe(15);
    expect(found.trials / found.frames, name).toBeLessThan(0.02);
    expect(found.compiled, `programs compiled in trials, ${name}`).toBe(0);
    expect(found.difference, name).toBeLessThan(0.02);
  }
  expect(seen.isOpen, 'a query of the timer is open between frames').toBe(false);
  expect(seen.kept).toContain('"version":2');
  expect([again.first, again.last, again.trials]).toEqual(['clustered-deferred', 'clustered-forward', 0]);
  expect([seen.byRule.first, seen.queriesOff]).toEqual(['clustered-deferred', 0]);
  expect(seen.cleared).toBe(null);
  expect(seen.back.last).toBe('clustered-deferred');
});
