import { isShading, type Shading } from '../shading/Shading';
import type { Viewport } from '../Viewport';
import { halfShare, type PaneShare } from './PaneShare';
import type { ViewPane } from './ViewPane';

/** The user's settings for the views, stored in the browser. */
export interface ViewChoice {
  readonly quad: boolean;
  readonly shadings: Readonly<Record<ViewPane['name'], Shading>>;
  /** Shares of the viewport for four views; halves when absent, as stored by older versions. */
  readonly share?: PaneShare;
}

export const defaultViews: ViewChoice = {
  quad: false,
  shadings: { main: 'scene', top: 'clay', front: 'clay', right: 'clay' },
};

/** Applies stored settings to the views. Unknown shadings are replaced by the defaults. */
export function applyViews(viewport: Viewport, { quad, shadings, share = halfShare }: ViewChoice): void {
  viewport.isQuad = quad;
  viewport.panes.share = share;
  viewport.invalidate();
  for (const pane of viewport.panes.list) {
    const chosen: unknown = shadings[pane.name];
    const shading = isShading(chosen) ? chosen : defaultViews.shadings[pane.name];
    if (shading !== pane.shading) viewport.shade(pane, shading);
  }
}
