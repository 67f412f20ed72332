import type { CompetitorName } from '../competitors/competitorNames';
import type { Stage } from '../stage/Stage';

/** Competitors that have an iframe of their own; all others share one iframe. */
const isolated: readonly string[] = ['three-webgpu', 'playcanvas', 'babylon'] satisfies CompetitorName[];

/** Time until `stage.html` must offer its stage (ms). */
const LONGEST_LOAD = 30_000;

/** Iframes with `stage.html`, each created when one of its competitors is first needed. */
export interface StageFrames {
  /**
   * Stage of the iframe in which a competitor draws.
   *
   * @throws Error (as a rejection) when the iframe does not load
   */
  stageOf(competitor: string): Promise<Stage>;
  /**
   * Hands the scene `own` to all existing iframes, and to those created later.
   *
   * @param file - a scene file of the engine with its assets
   */
  setOwnScene(file: Uint8Array): Promise<void>;
  close(): void;
}

/**
 * Creates iframes within a page when they are needed.
 *
 * @param parent - element that holds the iframes; they take no space on the page
 * @param url - URL of `stage.html`
 */
export function createStageFrames(parent: HTMLElement, url = './stage.html'): StageFrames {
  let ownScene: Uint8Array | null = null;
  const frames = new Map<string, { element: HTMLIFrameElement; stage: Promise<Stage> }>();
  return {
    stageOf(competitor) {
      const realm = isolated.includes(competitor) ? competitor : 'webgl';
      const existing = frames.get(realm);
      if (existing) return existing.stage;
      const element = document.createElement('iframe');
      element.title = 'Competitors that are measured';
      element.tabIndex = -1;
      element.setAttribute('aria-hidden', 'true');
      // off-screen and hidden by `visibility`: some browsers do not draw in an iframe with display: none
      element.style.cssText = 'position:fixed;left:-64px;top:0;width:32px;height:32px;border:0;visibility:hidden';
      const stage = loadStage(element, new URL(url, location.href).href).then(async (loaded) => {
        if (ownScene) await loaded.setOwnScene(ownScene);
        return loaded;
      });
      stage.catch(() => {
        if (frames.get(realm)?.element === element) frames.delete(realm);
        element.remove();
      });
      frames.set(realm, { element, stage });
      parent.append(element);
      return stage;
    },
    async setOwnScene(file) {
      ownScene = file;
      await Promise.all([...frames.values()].map(async ({ stage }) => (await stage).setOwnScene(file)));
    },
    close() {
      for (const { element } of frames.values()) element.remove();
      frames.clear();
    },
  };
}

function loadStage(element: HTMLIFrameElement, url: string): Promise<Stage> {
  return new Promise((resolve, reject) => {
    const failed = (why: string): void => {
      clearTimeout(timer);
      reject(new Error(`The frame that draws did not load (${why}): reload the page, or see its console.`));
    };
    const timer = setTimeout(() => failed(`no answer in ${LONGEST_LOAD / 1000} s`), LONGEST_LOAD);
    element.addEventListener('error', () => failed('it cannot be fetched'));
    // module scripts run before the load event, so the frame's stage must exist by then
    element.addEventListener('load', () => {
      const stage = stageIn(element);
      if (!stage) return failed('its script did not run');
      clearTimeout(timer);
      resolve(stage);
    });
    element.src = url;
  });
}

/** Stage of an iframe; undefined if the browser shows its error page there, which has another origin. */
function stageIn({ contentWindow }: HTMLIFrameElement): Stage | undefined {
  try {
    return contentWindow?.stage;
  } catch {
    return undefined;
  }
}
