import { t } from '@farol/editing';
import { useState } from 'preact/hooks';
import { saveFile } from '../results/saveFile';
import { messageOf } from '../run/messageOf';
import { chartPNG } from './chartPNG';
import { chartSVG } from './chartSVG';
import type { ChartSpec } from './ChartSpec';

/** Buttons that save a chart as a file, in the page's theme. */
export function ChartTools({ chart, source }: { chart: ChartSpec; source: string }) {
  const [problem, setProblem] = useState('');
  const save = async (kind: 'svg' | 'png', event: MouseEvent): Promise<void> => {
    try {
      const svg = chartSVG(chart, { theme: themeOf(event.currentTarget as HTMLElement), source });
      const blob = kind === 'svg' ? new Blob([svg], { type: 'image/svg+xml' }) : await chartPNG(svg);
      saveFile(`${chart.key}.${kind}`, blob);
      setProblem('');
    } catch (error) {
      setProblem(messageOf(error));
    }
  };
  return (
    <div class="chart-tools">
      {(['svg', 'png'] as const).map((kind) => (
        <button
          key={kind}
          type="button"
          aria-label={t('Save {kind}: {title}', { kind: kind.toUpperCase(), title: chart.title })}
          onClick={(event) => void save(kind, event)}
        >
          {kind.toUpperCase()}
        </button>
      ))}
      {problem !== '' && <span role="alert">{problem}</span>}
    </div>
  );
}

/** Theme of an element, by its `color-scheme`. */
function themeOf(element: HTMLElement): 'light' | 'dark' {
  const scheme = getComputedStyle(element).colorScheme;
  const isBoth = scheme.includes('light') === scheme.includes('dark');
  const isDark = isBoth ? matchMedia('(prefers-color-scheme: dark)').matches : scheme.includes('dark');
  return isDark ? 'dark' : 'light';
}
