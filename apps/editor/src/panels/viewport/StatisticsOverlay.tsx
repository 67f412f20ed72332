import { formatCount, t } from '@farol/editing';
import { type ReactNode, useCallback, useEffect, useRef } from 'react';
import { FigureList } from '../../ui/FigureList';
import { useEditor } from '../../ui/EditorContext';
import { usePoll } from '../../ui/usePoll';

/** Number of frames in the graph, and the time at its top edge (ms). */
const FRAMES = 120;
const TOP = 33.3;

/** Statistics over the viewport: texts updated four times per second, a graph with each frame. */
export function StatisticsOverlay(): ReactNode {
  const { viewport } = useEditor();
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const context = canvas.current!.getContext('2d')!;
    const times = new Float64Array(FRAMES);
    let last = 0;
    let at = 0;
    return viewport.drawn.subscribe(() => {
      const now = performance.now();
      times[at++ % FRAMES] = Math.min(now - last, 200);
      last = now;
      const { width, height } = context.canvas;
      context.clearRect(0, 0, width, height);
      for (let i = 0; i < FRAMES; i++) {
        const ms = times[(at + i) % FRAMES];
        const tall = Math.min(height, (ms / TOP) * height);
        context.fillStyle = ms > 34 ? '#f0696f' : ms > 17.5 ? '#ffc857' : '#7cc35a';
        context.fillRect(i * (width / FRAMES), height - tall, width / FRAMES, tall);
      }
    });
  }, [viewport]);
  const figures = usePoll(
    useCallback(() => {
      const { info } = viewport.farol;
      const { memory } = viewport.webgl.info;
      const rate = viewport.statistics.rate(performance.now());
      return [
        `${t('Frame')}\t${rate === null ? t('at rest') : `${formatCount(rate)} FPS, ${(1000 / rate).toFixed(1)} ms`}`,
        `CPU\t${info.cpuMs.toFixed(2)} ms`,
        `GPU\t${info.gpuMs === null ? t('not told') : `${info.gpuMs.toFixed(2)} ms`}`,
        `${t('Draws')}\t${formatCount(info.drawCalls)}`,
        `${t('Triangles')}\t${formatCount(info.triangles)}`,
        `${t('Lights')}\t${t('{visible} of {total}', { visible: info.lights.visible, total: info.lights.total })}`,
        `${t('Geometries')}\t${memory.geometries}`,
        `${t('Textures')}\t${memory.textures}`,
        `${t('Technique')}\t${viewport.technique}`,
      ].join('\n');
    }, [viewport]),
    4,
  );
  return (
    <section className="statistics" aria-label={t('Frame statistics')}>
      <canvas ref={canvas} width={240} height={40} aria-hidden="true" />
      <FigureList figures={figures.split('\n').map((line) => line.split('\t') as [string, string])} />
    </section>
  );
}
