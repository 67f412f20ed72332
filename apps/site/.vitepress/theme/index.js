import DefaultTheme from 'vitepress/theme-without-fonts';
import { defineAsyncComponent } from 'vue';
import Live from './Live.vue';
import './style.css';

/** Components of some pages only: others do not fetch their code. */
const late = {
  Costs: defineAsyncComponent(() => import('./Costs.vue')),
  Drawing: defineAsyncComponent(() => import('./Drawing.vue')),
  Example: defineAsyncComponent(() => import('./Example.vue')),
  Gallery: defineAsyncComponent(() => import('./Gallery.vue')),
};

/** @type {import('vitepress').Theme} */
export default {
  extends: DefaultTheme,
  enhanceApp({ app, router, siteData }) {
    app.component('Live', Live);
    for (const [name, component] of Object.entries(late)) app.component(name, component);
    // a page that has no Spanish text is shown in English
    router.onBeforeRouteChange = (to) => {
      const [path] = to.slice(siteData.value.base.length).split(/[?#]/);
      const page = `${path.replace(/\.html$/, '').replace(/(^|\/)$/, '$1index')}.md`;
      if (!path.startsWith('es/') || siteData.value.themeConfig.translated.includes(page)) return true;
      void router.go(siteData.value.base + path.slice(3));
      return false;
    };
  },
};
