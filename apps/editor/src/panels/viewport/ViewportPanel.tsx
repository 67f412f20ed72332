import { t } from '@farol/editing';
import { lazy, type ReactNode, Suspense, useLayoutEffect, useRef } from 'react';
import { PanelBoundary } from '../../ui/PanelBoundary';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { PointerControls } from '../../viewport/PointerControls';
import { viewOf } from '../../viewport/shading/Shading';
import './viewport.css';
import { PreviewFrame } from './PreviewFrame';
import { StatisticsOverlay } from './StatisticsOverlay';
import { ViewLine } from './ViewLine';
import { ViewportMenu } from './ViewportMenu';
import { ViewportToolbar } from './ViewportToolbar';

const PainterOverlay = lazy(async () => ({ default: (await import('../frame/PainterOverlay')).PainterOverlay }));
const PlayFrame = lazy(async () => ({ default: (await import('../play/PlayFrame')).PlayFrame }));
const ScriptsBar = lazy(async () => ({ default: (await import('../play/ScriptsBar')).ScriptsBar }));
const QuadOverlay = lazy(async () => ({ default: (await import('./QuadOverlay')).QuadOverlay }));
const ToolBox = lazy(async () => ({ default: (await import('./tools/ToolBox')).ToolBox }));
const ParticleBox = lazy(async () => ({ default: (await import('./ParticleBox')).ParticleBox }));
const ViewOverlay = lazy(async () => ({ default: (await import('../frame/ViewOverlay')).ViewOverlay }));

/** The viewport panel. The canvas belongs to Viewport; React only provides its parent. */
export function ViewportPanel(): ReactNode {
  const { viewport, document, tools } = useEditor();
  useSignal(viewport.changed);
  useSignal(tools.changed);
  const { simulation, scripts } = document;
  useSignal(simulation.changed);
  useSignal(scripts.changed);
  const place = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    viewport.canvas.ariaLabel = t('Picture of the scene: arrow keys turn it, plus and minus bring it nearer');
    viewport.panes.control(PointerControls);
    viewport.attach(place.current!);
    return () => viewport.detach();
  }, [viewport]);
  const particles = viewport.parts.particles.part;
  const isGrid = viewport.painter?.isGrid ?? false;
  const showsView = viewport.view !== 'final' || viewport.panes.list.some(({ shading }) => viewOf(shading));
  return (
    <section className="panel viewport" aria-label={t('Viewport')}>
      <div ref={place} className="viewport-place" />
      <ViewportMenu />
      {!isGrid && <ViewportToolbar />}
      {viewport.showStatistics && <StatisticsOverlay />}
      {!isGrid && <PreviewFrame />}
      <ViewLine />
      <PanelBoundary>
        <Suspense fallback={null}>
          {viewport.isQuad && <QuadOverlay />}
          {tools.current && <ToolBox key={tools.current.id} tool={tools.current} />}
          {particles && particles.emitters.length > 0 && <ParticleBox preview={particles} />}
          {viewport.painter && <PainterOverlay />}
          {simulation.state !== 'stopped' && <PlayFrame />}
          {scripts.question && scripts.areThere && <ScriptsBar />}
          {showsView && !viewport.painter && <ViewOverlay />}
        </Suspense>
      </PanelBoundary>
    </section>
  );
}
