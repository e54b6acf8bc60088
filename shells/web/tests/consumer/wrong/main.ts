// The control: a word that no direction has, and a field that no notice has.
import { load } from "dogleaf";

const dogleaf = await load();
const book = dogleaf.open({ pages: 24, direction: "upwards" });
for (const notice of book.notices()) console.log(notice.leaf);
