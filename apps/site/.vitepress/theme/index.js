import DefaultTheme from 'vitepress/theme-without-fonts';
import Costs from './Costs.vue';
import Drawing from './Drawing.vue';
import Example from './Example.vue';
import Gallery from './Gallery.vue';
import Live from './Live.vue';
import './style.css';

/** @type {import('vitepress').Theme} */
export default {
  extends: DefaultTheme,
  enhanceApp({ app, router, siteData }) {
    app.component('Costs', Costs);
    app.component('Drawing', Drawing);
    app.component('Example', Example);
    app.component('Gallery', Gallery);
    app.component('Live', Live);
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
