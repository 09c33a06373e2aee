//! Islands: bodies that share contact nodes. What happens at the contact points of one island within a step
//! does not depend on the others, so that threads can work on several at once.

use crate::state::Contact;

/// The bodies of a model in islands, and the contact nodes of each.
#[derive(Debug, Default)]
pub(crate) struct Islands {
    /// Island of each body, if it has contact points.
    of_body: Vec<Option<u32>>,
    /// Indices of the contact nodes of each island.
    pub(crate) nodes: Vec<Vec<u32>>,
    /// For each contact node its place in its island.
    pub(crate) place: Vec<u32>,
}

impl Islands {
    /// The islands of some contact points, which are in the order of the bodies, with so many nodes.
    pub(crate) fn new(contacts: &[Contact], corner_nodes: &[[u32; 8]], nodes: usize) -> Self {
        let bodies = contacts.last().map_or(0, |c| c.body as usize + 1);
        // Each body points to an earlier one of its island, the first to itself.
        let mut earlier: Vec<usize> = (0..bodies).collect();
        let mut owner = vec![None; nodes];
        for (c, corners) in contacts.iter().zip(corner_nodes) {
            for node in corners {
                let other = *owner[*node as usize].get_or_insert(c.body as usize);
                let [a, b] = [other, c.body as usize].map(|body| first(&earlier, body));
                earlier[a.max(b)] = a.min(b);
            }
        }
        let mut islands = Self { of_body: vec![None; bodies], nodes: Vec::new(), place: vec![0; nodes] };
        for (node, owner) in owner.into_iter().enumerate() {
            if let Some(owner) = owner {
                let island = islands.number(first(&earlier, owner));
                islands.of_body[owner] = Some(island);
                let own = &mut islands.nodes[island as usize];
                islands.place[node] = own.len() as u32;
                own.push(node as u32);
            }
        }
        for c in contacts {
            let body = c.body as usize;
            islands.of_body[body] = islands.of_body[first(&earlier, body)];
        }
        islands
    }

    /// The number of the island whose first body this is.
    fn number(&mut self, body: usize) -> u32 {
        *self.of_body[body].get_or_insert_with(|| {
            self.nodes.push(Vec::new());
            self.nodes.len() as u32 - 1
        })
    }

    /// Memory in use [bytes].
    pub(crate) fn memory(&self) -> usize {
        let nodes = self.nodes.iter().map(|own| size_of_val(own.as_slice())).sum::<usize>();
        nodes + size_of_val(self.of_body.as_slice()) + size_of_val(self.place.as_slice())
    }

    /// The island of a body that has contact points.
    pub(crate) fn of(&self, body: usize) -> usize {
        self.of_body[body].map_or(0, |island| island as usize)
    }
}

/// The first body of an island.
fn first(earlier: &[usize], mut body: usize) -> usize {
    while earlier[body] != body {
        body = earlier[body];
    }
    body
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Contacts of these bodies at these eight nodes each.
    fn islands(each: &[(u32, u32)]) -> Islands {
        let contacts: Vec<_> =
            each.iter().map(|(body, _)| Contact { body: *body, ..Contact::default() }).collect();
        let corners: Vec<[u32; 8]> =
            each.iter().map(|(_, node)| std::array::from_fn(|n| node + n as u32)).collect();
        let nodes = each.iter().map(|(_, node)| *node as usize + 8).max().unwrap_or(0);
        Islands::new(&contacts, &corners, nodes)
    }

    #[test]
    fn bodies_that_share_nodes_are_one_island() {
        let found = islands(&[(0, 0), (1, 8), (3, 16), (3, 4)]);
        assert_eq!([0, 1, 3].map(|body| found.of(body)), [0, 0, 0], "the last body connects the others");
        let found = islands(&[(0, 20), (1, 0), (1, 4), (2, 24), (4, 10)]);
        assert_eq!([0, 2].map(|body| found.of(body)), [found.of(0); 2]);
        assert_eq!([1, 4].map(|body| found.of(body)), [found.of(1); 2]);
        assert_ne!(found.of(0), found.of(1));
        assert_eq!(found.nodes.len(), 2);
        for own in &found.nodes {
            assert!(
                own.iter().enumerate().all(|(place, node)| found.place[*node as usize] as usize == place)
            );
        }
    }

    #[test]
    fn without_contacts_there_are_none() {
        assert!(islands(&[]).nodes.is_empty());
    }
}
