import { t } from '@farol/editing';
import { useMemo, useState } from 'preact/hooks';
import type { LabRun, Metric } from '../results/LabRun';
import { ChartControls } from './ChartControls';
import { ChartFigure } from './ChartFigure';
import { defaultSettings, type ChartSettings } from './ChartSpec';
import { chartsOf } from './chartsOf';
import { paintProperties } from './chartPaint';
import { competitorOrder } from './competitorMarks';
import { runNames, sourceOf } from './runNames';
import './charts.css';

/** All charts of one run, or of several runs together. */
export function RunCharts({ runs, metric = 'frame' }: { runs: readonly LabRun[]; metric?: Metric }) {
  const [settings, setSettings] = useState<ChartSettings>({ ...defaultSettings, metric });
  const charts = useMemo(() => chartsOf(runs, settings), [runs, settings]);
  const names = useMemo(() => runNames(runs), [runs]);
  const competitors = useMemo(() => {
    const all = new Set(runs.flatMap(({ plan }) => plan.competitors));
    return [...all].sort((a, b) => competitorOrder(a) - competitorOrder(b));
  }, [runs]);
  const source = useMemo(() => sourceOf(runs), [runs]);
  const choose = (key: string, index: number): void =>
    setSettings({ ...settings, cases: { ...settings.cases, [key]: index } });
  return (
    <section class="charts" aria-label={t('Charts')} style={paintProperties}>
      <ChartControls {...{ runs, names, competitors, settings }} onChange={setSettings} />
      <div class="chart-grid">
        {charts.map((chart) => (
          <ChartFigure key={chart.key} chart={chart} source={source} onChoose={(index) => choose(chart.key, index)} />
        ))}
      </div>
    </section>
  );
}
