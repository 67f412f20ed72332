import { t } from '@farol/editing';
import { useId, useLayoutEffect, useRef, useState } from 'preact/hooks';
import type { ChartPoint, ChartSpec } from './ChartSpec';
import { ChartTableView } from './ChartTableView';
import { ChartTools } from './ChartTools';
import { pagePaint } from './chartPaint';
import { useChartSize } from './useChartSize';
import { nearestPoint, walkPoints } from './walkPoints';

/** Distance within which the pointer chooses a point (pixels). */
const REACH = 48;

interface Props {
  chart: ChartSpec;
  /** Device, browser and date of the measurements, written into saved files. */
  source: string;
  onChoose: (index: number) => void;
}

/** A chart with its title, notes, a table of its values, and buttons that save it as a file. */
export function ChartFigure({ chart, source, onChoose }: Props) {
  const id = useId();
  const [showsTable, setShowsTable] = useState(false);
  return (
    <figure class="chart" aria-labelledby={`${id}-title`} data-chart={chart.key}>
      <header>
        <h3 id={`${id}-title`}>{chart.title}</h3>
        {chart.choice && (
          <label>
            {chart.choice.label}{' '}
            <select value={chart.choice.selected} onChange={(event) => onChoose(Number(event.currentTarget.value))}>
              {chart.choice.options.map((option, i) => (
                <option key={option} value={i}>
                  {option}
                </option>
              ))}
            </select>
          </label>
        )}
      </header>
      <ChartDrawing chart={chart} />
      {chart.keys && (
        <ul class="chart-keys" aria-label={t('Colours')}>
          {chart.keys.map(({ label, colour }) => (
            <li key={label}>
              <span style={{ background: colour(pagePaint) }} />
              {label}
            </li>
          ))}
        </ul>
      )}
      {chart.notes?.map((note) => (
        <p key={note} class="chart-note">
          {note}
        </p>
      ))}
      <footer>
        <details class="chart-table" onToggle={(event) => setShowsTable(event.currentTarget.open)}>
          <summary>{t('Table')}</summary>
          {showsTable && <ChartTableView table={chart.table} caption={chart.title} />}
        </details>
        <ChartTools chart={chart} source={source} />
      </footer>
    </figure>
  );
}

/** The drawing, with a note at the point that the pointer or the arrow keys chose. */
function ChartDrawing({ chart }: { chart: ChartSpec }) {
  const host = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLDivElement>(null);
  const drawnFor = useRef<{ chart: ChartSpec; width: number } | null>(null);
  const points = useRef<readonly ChartPoint[]>([]);
  const [current, setCurrent] = useState<{ point: ChartPoint; byKey: boolean } | null>(null);
  const { width, isNear } = useChartSize(host);

  useLayoutEffect(() => {
    if (width === 0 || !isNear || (drawnFor.current?.chart === chart && drawnFor.current.width === width)) return;
    drawnFor.current = { chart, width };
    const drawn = chart.draw({ width, paint: pagePaint });
    const { height, svg } = drawn;
    const style = `font-size="12" text-anchor="middle" fill="${pagePaint.text}"`;
    canvas.current!.innerHTML = `<svg width="${width}" height="${height}" ${style} aria-hidden="true">${svg}</svg>`;
    points.current = drawn.points;
    host.current!.dataset.drawn = '';
    // the note moves to the chosen point's place in the new drawing, or disappears with the point
    setCurrent((old) => {
      const same = drawn.points.find(({ group, order }) => group === old?.point.group && order === old.point.order);
      return old && same ? { ...old, point: same } : null;
    });
  }, [chart, width, isNear]);

  useLayoutEffect(() => {
    for (const element of canvas.current!.querySelectorAll('.group')) {
      element.classList.toggle(
        'chart-faded',
        current !== null && !element.classList.contains(`group-${current.point.group}`),
      );
    }
  }, [current]);

  const point = (event: PointerEvent): void => {
    const box = canvas.current!.getBoundingClientRect();
    const nearest = nearestPoint(points.current, event.clientX - box.left, event.clientY - box.top, REACH);
    if (nearest !== current?.point) setCurrent(nearest && { point: nearest, byKey: false });
  };
  const walk = (event: KeyboardEvent): void => {
    if (event.key === 'Escape') setCurrent(null);
    const next = walkPoints(points.current, current?.point ?? null, event.key);
    if (!next) return;
    event.preventDefault();
    setCurrent({ point: next, byKey: true });
  };

  return (
    <div
      ref={host}
      class="chart-drawing"
      role="application"
      aria-roledescription={t('chart')}
      aria-label={t('{title}. {description} Arrow keys walk the points; the table below has all figures.', {
        title: chart.title,
        description: chart.description,
      })}
      tabIndex={0}
      onPointerMove={point}
      onPointerDown={point}
      onPointerLeave={() => setCurrent(null)}
      onKeyDown={walk}
      onBlur={() => setCurrent(null)}
    >
      <div ref={canvas} class="chart-canvas" />
      {current && <PointNote point={current.point} width={width} />}
      <p class="chart-spoken" aria-live="polite">
        {current?.byKey ? [current.point.tip.title, ...current.point.tip.lines].join('. ') : ''}
      </p>
    </div>
  );
}

function PointNote({ point: { x, y, tip }, width }: { point: ChartPoint; width: number }) {
  const isRight = x > width / 2;
  const side = isRight ? { right: `${Math.max(0, width - x + 14)}px` } : { left: `${x + 14}px` };
  const room = Math.max(180, Math.min(320, (isRight ? x : width - x) - 14));
  return (
    <>
      <span class="chart-cursor" style={{ left: `${x}px`, top: `${y}px` }} />
      <div class="chart-tip" style={{ ...side, top: `${y}px`, maxWidth: `${room}px` }} aria-hidden="true">
        <strong>{tip.title}</strong>
        {tip.lines.map((line) => (
          <span key={line}>{line}</span>
        ))}
      </div>
    </>
  );
}
