import { paintOf } from '../charts/chartPaint';
import { chartsOf } from '../charts/chartsOf';
import { defaultSettings, type ChartSettings, type ChartSpec } from '../charts/ChartSpec';
import type { RunFile } from './exportRun';
import type { LabRun } from './LabRun';
import type { ChartWords } from './runMarkdown';

/** All charts of a run as files, drawn for light paper. */
export async function chartFiles(
  run: LabRun,
  kind: 'svg' | 'png',
  settings: ChartSettings = defaultSettings,
): Promise<RunFile[]> {
  return Promise.all(
    chartsOf([run], settings).map(async (chart) => ({
      name: `${chart.key}.${kind}`,
      content: kind === 'png' ? await chartPNG(chart) : new Blob([chartSVG(chart)], { type: 'image/svg+xml' }),
    })),
  );
}

/** The same as texts, with what each chart says. */
export function chartTexts(run: LabRun): {
  words: readonly ChartWords[];
  drawings: readonly { name: string; text: string }[];
} {
  const charts = chartsOf([run], defaultSettings);
  return { words: charts, drawings: charts.map((chart) => ({ name: `${chart.key}.svg`, text: chartSVG(chart) })) };
}

/** Width of a chart in files (CSS pixels). */
const WIDTH = 960;

function chartSVG(chart: ChartSpec): string {
  const { svg } = chart.draw({ width: WIDTH, paint: paintOf('light') });
  return new XMLSerializer().serializeToString(svg);
}

async function chartPNG(chart: ChartSpec): Promise<Blob> {
  const image = new Image();
  image.src = URL.createObjectURL(new Blob([chartSVG(chart)], { type: 'image/svg+xml' }));
  try {
    await image.decode();
    const canvas = document.createElement('canvas');
    Object.assign(canvas, { width: image.naturalWidth * 2, height: image.naturalHeight * 2 });
    const context = canvas.getContext('2d')!;
    context.fillStyle = paintOf('light').background;
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.drawImage(image, 0, 0, canvas.width, canvas.height);
    return await new Promise((resolve, reject) =>
      canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('The browser makes no PNG.')))),
    );
  } finally {
    URL.revokeObjectURL(image.src);
  }
}
