import type { Competitor, Drawing } from '../Competitor';
import { competitorNames } from '../competitorNames';
import { noGouraud, pointsAlone, refuseMatter } from '../refuseMatter';
import { installCommand, type InstalledRivals, installedRivals } from '../installedRivals';
import { describeScene } from './describeScene';
import { LinkedPrograms } from './LinkedPrograms';
import type { RivalModule } from './RivalScene';
import { SceneFollower } from './SceneFollower';

/** Address of an engine's module, beside the page. */
const moduleUrl = (name: string): string => new URL(`rivals/${name}.js`, document.baseURI).href;

/** Names of the engines within texts, by key. */
const engines = { playcanvas: 'PlayCanvas', babylon: 'Babylon.js' } as const;

export type RivalName = keyof typeof engines;

interface RivalOptions {
  /** Fetches the module; replaced in tests. */
  readonly load?: () => Promise<RivalModule>;
  /** Installed engines; replaced in tests. */
  readonly installed?: () => Promise<InstalledRivals>;
}

/** Another engine as a competitor; its module is fetched when it first draws. */
export function rivalCompetitor(
  name: RivalName,
  {
    load = async () => (await import(/* @vite-ignore */ moduleUrl(name))) as RivalModule,
    installed = installedRivals,
  }: RivalOptions = {},
): Competitor {
  const engine = engines[name];
  return {
    name,
    ...competitorNames[name],
    async unavailable() {
      const { versions } = await installed();
      return name in versions ? null : `${engine} is not installed: run ${installCommand}, then load the page anew.`;
    },
    refuses(scene) {
      const lacking = refuseMatter(scene, { kinds: pointsAlone(`${engine} is`), shadings: noGouraud(engine) });
      if (lacking !== null) return lacking;
      return scene.shadows > 0 ? `${engine}’s clustered lights are measured without shadows.` : null;
    },
    async open(canvas, stageScene, signal): Promise<Drawing> {
      const described = describeScene(stageScene);
      const module = await load();
      signal.throwIfAborted();
      const drawing = module.open(canvas, described.scene, signal);
      const programs = new LinkedPrograms(drawing.gl);
      const follower = new SceneFollower(stageScene, described, drawing);
      return {
        gl: drawing.gl,
        render: () => drawing.render(),
        async drawFirst() {
          await drawing.drawFirst();
          follower.start();
        },
        check: () => programs.check(),
        lightsMoved: () => follower.follow(),
        lightsChanged: () => follower.changeLights(),
        dropped: () => drawing.dropped(),
        dispose: () => drawing.dispose(),
      };
    },
  };
}
