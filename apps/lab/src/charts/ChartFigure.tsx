import { useId, useLayoutEffect, useRef, useState } from 'preact/hooks';
import type { ChartPoint, ChartSpec } from './ChartSpec';
import { ChartTableView } from './ChartTableView';
import { ChartTools } from './ChartTools';
import { pagePaint } from './chartPaint';
import { useChartSize } from './useChartSize';
import { nearestPoint, walkPoints } from './walkPoints';

/** How near the pointer must come to a point (pixels). */
const REACH = 48;

interface Props {
  chart: ChartSpec;
  /** Where the figures come from, for files. */
  source: string;
  onChoose: (index: number) => void;
}

/** A chart with its title, sentences, table and files. */
export function ChartFigure({ chart, source, onChoose }: Props) {
  const id = useId();
  const [showsTable, setShowsTable] = useState(false);
  return (
    <figure class={`chart${chart.wide ? ' chart-wide' : ''}`} aria-labelledby={`${id}-title`} data-chart={chart.key}>
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
      <div class="chart-body">
        <div>
          <ChartDrawing chart={chart} />
          {chart.keys.length > 0 && (
            <ul class="chart-keys" aria-label="Colours">
              {chart.keys.map(({ label, colour }) => (
                <li key={label}>
                  <span style={{ background: colour(pagePaint) }} />
                  {label}
                </li>
              ))}
            </ul>
          )}
        </div>
        <figcaption>
          {chart.sentences.map((sentence) => (
            <p key={sentence}>{sentence}</p>
          ))}
          {chart.verdicts.length > 0 && (
            <ul class="chart-verdicts">
              {chart.verdicts.map(({ claim, verdict, evidence }) => (
                <li key={claim} data-verdict={verdict}>
                  <strong>{verdict}</strong>
                  <q>{claim}</q> {evidence}
                </li>
              ))}
            </ul>
          )}
          {chart.notes.map((note) => (
            <p key={note} class="chart-note">
              {note}
            </p>
          ))}
        </figcaption>
      </div>
      <footer>
        <details class="chart-table" onToggle={(event) => setShowsTable(event.currentTarget.open)}>
          <summary>Table</summary>
          {showsTable && <ChartTableView table={chart.table} caption={chart.title} />}
        </details>
        <ChartTools chart={chart} source={source} />
      </footer>
    </figure>
  );
}

/** The drawing, with a note at the point under the pointer or reached by arrow keys. */
function ChartDrawing({ chart }: { chart: ChartSpec }) {
  const host = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLDivElement>(null);
  const shown = useRef<{ chart: ChartSpec; width: number } | null>(null);
  const points = useRef<readonly ChartPoint[]>([]);
  const [current, setCurrent] = useState<{ point: ChartPoint; byKey: boolean } | null>(null);
  const { width, isNear } = useChartSize(host);

  useLayoutEffect(() => {
    if (width === 0 || !isNear || (shown.current?.chart === chart && shown.current.width === width)) return;
    shown.current = { chart, width };
    const drawn = chart.draw({ width, paint: pagePaint });
    drawn.svg.setAttribute('aria-hidden', 'true');
    canvas.current!.replaceChildren(drawn.svg);
    points.current = drawn.points;
    host.current!.dataset.drawn = '';
    // the same point may stand elsewhere now
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
      aria-roledescription="chart"
      aria-label={`${chart.title}. ${chart.description} Arrow keys walk the points; the table below has all figures.`}
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
