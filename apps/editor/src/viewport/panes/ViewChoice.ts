import { isShading, type Shading } from '../shading/Shading';
import type { Viewport } from '../Viewport';
import { halfShare, type PaneShare } from './PaneShare';
import type { ViewPane } from './ViewPane';

/** What the user has chosen of the views; kept in the browser. */
export interface ViewChoice {
  /** Whether there are four. */
  readonly quad: boolean;
  /** How each shows the scene. */
  readonly shadings: Readonly<Record<ViewPane['name'], Shading>>;
  /** How four share the picture; halves when absent, as of older versions. */
  readonly share?: PaneShare;
}

export const defaultViews: ViewChoice = {
  quad: false,
  shadings: { main: 'scene', top: 'clay', front: 'clay', right: 'clay' },
};

/** Brings the views to what is chosen. What is no shading is as at first. */
export function applyViews(viewport: Viewport, { quad, shadings, share = halfShare }: ViewChoice): void {
  viewport.isQuad = quad;
  viewport.shareViews(share);
  for (const pane of viewport.panes.list) {
    const chosen: unknown = shadings[pane.name];
    const shading = isShading(chosen) ? chosen : defaultViews.shadings[pane.name];
    if (shading !== pane.shading) viewport.shade(pane, shading);
  }
}
