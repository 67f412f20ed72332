import type { Competitor, Drawing } from '../Competitor';
import { competitorNames } from '../competitorNames';
import { installCommand, installedRivals } from '../installedRivals';
import { describeScene } from './describeScene';
import type { RivalModule } from './RivalScene';
import { SceneFollower } from './SceneFollower';

/** Where a rival's module lies, beside the page. */
const moduleUrl = (name: string): string => new URL(`rivals/${name}.js`, document.baseURI).href;

interface RivalOptions {
  readonly name: 'playcanvas' | 'babylon';
  /** Name in sentences. */
  readonly engine: string;
  /** Fetches the module: for tests. */
  readonly load?: () => Promise<RivalModule>;
  /** Whether the module is there: for tests. */
  readonly isInstalled?: () => Promise<boolean>;
}

/** Another engine as a competitor: its module is fetched when it is chosen. */
export function rivalCompetitor({
  name,
  engine,
  load = async () => (await import(/* @vite-ignore */ moduleUrl(name))) as RivalModule,
  isInstalled = async () => name in (await installedRivals()).versions,
}: RivalOptions): Competitor {
  return {
    name,
    ...competitorNames[name],
    async unavailable() {
      return (await isInstalled())
        ? null
        : `${engine} is not installed: run ${installCommand}, then load the page anew.`;
    },
    refuses({ shadows }) {
      return shadows > 0 ? `${engine}’s clustered lights are measured without shadows.` : null;
    },
    async open(canvas, stageScene, signal): Promise<Drawing> {
      const described = describeScene(stageScene);
      const module = await load();
      signal.throwIfAborted();
      const drawing = module.open(canvas, described.scene, signal);
      const follower = new SceneFollower(stageScene, described, drawing);
      return {
        gl: drawing.gl,
        render: () => drawing.render(),
        drawFirst: () => drawing.drawFirst(),
        lightsMoved: () => follower.follow(),
        lightsChanged: () => follower.changeLights(),
        dropped: () => drawing.dropped(),
        dispose: () => drawing.dispose(),
      };
    },
  };
}
